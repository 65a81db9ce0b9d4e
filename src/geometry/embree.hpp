// SPDX-License-Identifier: MIT
// The part of Embree's C interface that Nicol calls. The library is opened at run time and called through a
// table of functions, because a host may have another version of Embree in its process, which defines the
// same names.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

namespace nicol::embree {

struct Device;
struct Scene;
struct Geometry;

// Constants and structures have the same layout in versions 3 and 4 of Embree.
inline constexpr int kErrorNone = 0;
inline constexpr int kErrorUnknown = 1;
inline constexpr int kErrorOutOfMemory = 4;
inline constexpr int kSceneRobust = 1 << 2;
inline constexpr int kTriangleGeometry = 0;
inline constexpr int kIndexBuffer = 0;
inline constexpr int kVertexBuffer = 1;
inline constexpr int kFormatUint3 = 0x5003;
inline constexpr int kFormatFloat3 = 0x9003;
inline constexpr unsigned kNoGeometry = std::numeric_limits<unsigned>::max();

struct alignas(16) Ray {
    float org_x, org_y, org_z, tnear;
    float dir_x, dir_y, dir_z, time;
    float tfar;  ///< negative in the answer: something is in the way
    unsigned mask, id, flags;
};

struct alignas(16) Hit {
    float ng_x, ng_y, ng_z, u, v;
    unsigned triangle, geometry, instance;
    unsigned instance_primitive;  ///< of version 4
};

struct RayHit {
    Ray ray;
    Hit hit;
};

struct alignas(64) Ray16 {
    static constexpr std::size_t kRays = 16;
    std::array<float, kRays> org_x, org_y, org_z, tnear;
    std::array<float, kRays> dir_x, dir_y, dir_z, time;
    std::array<float, kRays> tfar;  ///< as in Ray
    std::array<unsigned, kRays> mask, id, flags;
};

/// Hits for a filter to accept or to refuse, which it does by valid[i] = 0.
struct FilterArguments {
    int* valid;
    void* user_data;
    void* context;
    void* rays;
    void* hits;  ///< `count` values of each field of Hit, field by field
    unsigned count;

    [[nodiscard]] float u(unsigned i) const { return static_cast<const float*>(hits)[3 * count + i]; }
    [[nodiscard]] float v(unsigned i) const { return static_cast<const float*>(hits)[4 * count + i]; }
    [[nodiscard]] unsigned triangle(unsigned i) const {
        return static_cast<const unsigned*>(hits)[5 * count + i];
    }
};
using Filter = void (*)(const FilterArguments*);

/// Embree's functions under their own names, without the prefix `rtc`.
class Library {
public:
    Library();

    [[nodiscard]] int version() const noexcept { return version_; }

    Device* (*NewDevice)(const char* config) = nullptr;
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
    void (*SetGeometryUserData)(Geometry*, void*) = nullptr;
    void (*SetGeometryIntersectFilterFunction)(Geometry*, Filter) = nullptr;
    void (*SetGeometryOccludedFilterFunction)(Geometry*, Filter) = nullptr;

    void intersect(Scene* scene, RayHit& query) const;
    void occluded(Scene* scene, Ray& ray) const;
    /// Traces the rays whose `valid` is -1, not 0. Faster where they are near to each other.
    void occluded(Scene* scene, const std::array<int, Ray16::kRays>& valid, Ray16& rays) const;

private:
    using Function = void (*)();
    int version_ = 0;
    Function intersect1_ = nullptr, occluded1_ = nullptr, occluded16_ = nullptr;
};

/// Opens Embree 4 where there is one, else Embree 3, in the first call. Throws Error(unsupported) naming the
/// packages if there is neither.
[[nodiscard]] const Library& library();
/// Opens it as library() does; where there is none, library() will say so.
void open_if_there() noexcept;

}  // namespace nicol::embree
