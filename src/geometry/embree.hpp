// SPDX-License-Identifier: MIT
// The part of Embree's C interface that Nicol calls. Nicol opens the library at run time and calls it through
// a table of functions, because a host may have another version of Embree in its process that defines equal
// names.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

namespace nicol::embree {

struct Device;
struct Scene;
struct Geometry;

// Constants and structures whose layout is equal in versions 3 and 4 of Embree.
inline constexpr int kErrorNone = 0;
inline constexpr int kErrorUnknown = 1;
inline constexpr int kErrorOutOfMemory = 4;
inline constexpr int kSceneRobust = 1 << 2;
inline constexpr int kTriangleGeometry = 0;
inline constexpr int kInstanceGeometry = 121;
inline constexpr int kIndexBuffer = 0;
inline constexpr int kVertexBuffer = 1;
inline constexpr int kFormatUint3 = 0x5003;
inline constexpr int kFormatFloat3 = 0x9003;
inline constexpr unsigned kNoGeometry = std::numeric_limits<unsigned>::max();

struct alignas(16) Ray {
    float org_x, org_y, org_z, tnear;
    float dir_x, dir_y, dir_z, time;
    float tfar;  ///< length; a negative length in the answer means that the ray is occluded
    unsigned mask, id, flags;
};

struct alignas(16) Hit {
    float ng_x, ng_y, ng_z, u, v;
    unsigned triangle, geometry, instance;
    unsigned instance_primitive;  ///< used by version 4 only
};

struct RayHit {
    Ray ray;
    Hit hit;
};

struct alignas(64) Ray16 {
    static constexpr std::size_t kRays = 16;
    std::array<float, kRays> org_x, org_y, org_z, tnear;
    std::array<float, kRays> dir_x, dir_y, dir_z, time;
    std::array<float, kRays> tfar;  ///< length; negative in the answer if the ray is occluded
    std::array<unsigned, kRays> mask, id, flags;

    void set(std::size_t i, const Ray& of) {
        org_x[i] = of.org_x;
        org_y[i] = of.org_y;
        org_z[i] = of.org_z;
        tnear[i] = of.tnear;
        dir_x[i] = of.dir_x;
        dir_y[i] = of.dir_y;
        dir_z[i] = of.dir_z;
        tfar[i] = of.tfar;
        mask[i] = of.mask;
    }
};

struct alignas(64) RayHit16 {
    Ray16 ray;
    std::array<float, Ray16::kRays> ng_x, ng_y, ng_z, u, v;
    std::array<unsigned, Ray16::kRays> triangle, geometry, instance;
    std::array<unsigned, Ray16::kRays> instance_primitive;  ///< used by version 4 only

    [[nodiscard]] Hit hit(std::size_t i) const {
        return {ng_x[i], ng_y[i], ng_z[i], u[i], v[i], triangle[i], geometry[i], instance[i], 0};
    }
};

/// Hits that a filter accepts or, by valid[i] = 0, rejects.
struct FilterArguments {
    int* valid;
    void* user_data;
    void* context;
    void* rays;  ///< `count` values of each field of Ray, field by field
    void* hits;  ///< `count` values of each field of Hit, field by field
    unsigned count;

    /// Returns whether ray i meets the front of its triangle.
    [[nodiscard]] bool meets_front(unsigned i) const {
        const auto* const direction = static_cast<const float*>(rays) + 4 * std::size_t{count} + i;
        const auto* const normal = static_cast<const float*>(hits) + i;
        return direction[0] * normal[0] + direction[count] * normal[count] +
                   direction[2 * std::size_t{count}] * normal[2 * std::size_t{count}] <
               0;
    }
    [[nodiscard]] float u(unsigned i) const { return static_cast<const float*>(hits)[3 * count + i]; }
    [[nodiscard]] float v(unsigned i) const { return static_cast<const float*>(hits)[4 * count + i]; }
    [[nodiscard]] unsigned triangle(unsigned i) const {
        return static_cast<const unsigned*>(hits)[5 * count + i];
    }
};
using Filter = void (*)(const FilterArguments*);

/// Table of Embree's functions, under Embree's names without the prefix `rtc`.
class Library {
public:
    Library();

    [[nodiscard]] int version() const noexcept { return version_; }

    Device* (*NewDevice)(const char* config) = nullptr;
    void (*RetainDevice)(Device*) = nullptr;
    void (*ReleaseDevice)(Device*) = nullptr;
    int (*GetDeviceError)(Device*) = nullptr;
    Scene* (*NewScene)(Device*) = nullptr;
    void (*ReleaseScene)(Scene*) = nullptr;
    void (*SetSceneFlags)(Scene*, int flags) = nullptr;
    void (*CommitScene)(Scene*) = nullptr;
    Geometry* (*NewGeometry)(Device*, int type) = nullptr;
    void (*ReleaseGeometry)(Geometry*) = nullptr;
    void (*CommitGeometry)(Geometry*) = nullptr;
    void (*AttachGeometryByID)(Scene*, Geometry*, unsigned id) = nullptr;
    void (*DetachGeometry)(Scene*, unsigned) = nullptr;
    void* (*SetNewGeometryBuffer)(Geometry*, int buffer, unsigned slot, int format, std::size_t stride,
                                  std::size_t count) = nullptr;
    void (*SetGeometryInstancedScene)(Geometry*, Scene*) = nullptr;
    void (*SetGeometryUserData)(Geometry*, void*) = nullptr;
    void (*SetGeometryIntersectFilterFunction)(Geometry*, Filter) = nullptr;
    void (*SetGeometryOccludedFilterFunction)(Geometry*, Filter) = nullptr;

    void intersect(Scene* scene, RayHit& query) const;
    /// Finds the first hits of the rays whose `valid` is -1, see occluded().
    void intersect(Scene* scene, const std::array<int, Ray16::kRays>& valid, RayHit16& query,
                   bool coherent) const;
    void occluded(Scene* scene, Ray& ray) const;
    /// Traces the rays whose `valid` is -1 (0: not traced). coherent: whether Embree traces them as one beam,
    /// which is faster for rays close to each other.
    void occluded(Scene* scene, const std::array<int, Ray16::kRays>& valid, Ray16& rays, bool coherent) const;

private:
    using Function = void (*)();
    int version_ = 0;
    Function intersect1_ = nullptr, intersect16_ = nullptr, occluded1_ = nullptr, occluded16_ = nullptr;
};

/// Opens Embree 4, or else Embree 3, in the first call. Throws Error(unsupported), which names the packages,
/// if neither is installed.
[[nodiscard]] const Library& library();
/// Opens Embree as library() does, without throwing; a later library() reports the failure.
void open_if_there() noexcept;

}  // namespace nicol::embree
