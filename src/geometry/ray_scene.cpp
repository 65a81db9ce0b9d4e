// SPDX-License-Identifier: MIT
#include "geometry/ray_scene.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "error.hpp"
#include "geometry/largest_coordinate.hpp"

namespace nicol {
namespace {

constexpr float kSmallestScene = 1e-6F;
constexpr double kLeftOut = 1e-4;  // of a ray, at its end

[[noreturn]] void refuse(std::size_t surface, const std::string& message) {
    throw Error(ErrorCode::invalid_argument, "surface " + std::to_string(surface) + ": " + message);
}

/// The largest coordinate.
float check(std::size_t index, const RaySurface& surface) {
    float largest = 0;
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
        const glm::vec3& p = surface.positions[v];
        for (int axis = 0; axis < 3; ++axis) {
            if (!(std::abs(p[axis]) <= kLargestCoordinate)) {
                refuse(index, "vertex " + std::to_string(v) + " is not finite or beyond 1e15");
            }
            largest = std::max(largest, std::abs(p[axis]));
        }
    }
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const glm::uvec3& corners = surface.triangles[t];
        if (std::max({corners.x, corners.y, corners.z}) >= surface.positions.size()) {
            refuse(index, "triangle " + std::to_string(t) + " has a vertex that does not exist; there are " +
                              std::to_string(surface.positions.size()));
        }
    }
    return largest;
}

// Leaves out hits where the surface is not there.
void filter(const RTCFilterFunctionNArguments* hits) {
    const auto& present = *static_cast<const Presence*>(hits->geometryUserPtr);
    for (unsigned i = 0; i < hits->N; ++i) {
        if (hits->valid[i] == 0) continue;
        if (!present(RTCHitN_primID(hits->hit, hits->N, i), RTCHitN_u(hits->hit, hits->N, i),
                     RTCHitN_v(hits->hit, hits->N, i)))
            hits->valid[i] = 0;
    }
}

}  // namespace

struct RayScene::Embree {
    template <auto release>
    struct Release {
        template <class T>
        void operator()(T* object) const {
            release(object);
        }
    };
    std::unique_ptr<RTCDeviceTy, Release<rtcReleaseDevice>> device{rtcNewDevice(nullptr)};
    std::unique_ptr<RTCSceneTy, Release<rtcReleaseScene>> scene;

    Embree() {
        if (device) scene.reset(rtcNewScene(device.get()));
        check();
        rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
    }

    void check() const {
        const RTCError error = rtcGetDeviceError(device.get());
        if (error == RTC_ERROR_NONE && scene) return;
        if (error == RTC_ERROR_OUT_OF_MEMORY) {
            throw Error(ErrorCode::out_of_memory, "not enough memory for the rays' hierarchy of boxes");
        }
        throw Error(ErrorCode::internal,
                    "Embree failed with error " + std::to_string(static_cast<int>(error)));
    }

    /// The bits of `active` whose rays meet something. Faster where these are near to each other.
    std::uint16_t occluded(RTCRay16& rays, unsigned active) const {
        constexpr std::size_t count = RayPacket::kRays;
        alignas(64) std::array<int, count> valid{};
        for (std::size_t i = 0; i < count; ++i) valid[i] = (active >> i & 1) != 0 ? -1 : 0;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        rtcOccluded16(valid.data(), scene.get(), &context, &rays);
        unsigned blocked = 0;
        for (std::size_t i = 0; i < count; ++i) blocked |= (rays.tfar[i] < 0 ? 1U : 0U) << i;
        return static_cast<std::uint16_t>(blocked & active);
    }

    /// `present` must outlive the scene; null: everywhere.
    void add(const RaySurface& surface, const Presence* present, unsigned id, float scale) {
        RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
        const std::size_t vertices = surface.positions.size();
        const std::size_t triangles = surface.triangles.size();
        void* positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                  sizeof(glm::vec3), vertices);
        void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                sizeof(glm::uvec3), triangles);
        if (positions != nullptr && indices != nullptr) {
            std::ranges::transform(surface.positions, static_cast<glm::vec3*>(positions),
                                   [scale](const glm::vec3& p) { return scale * p; });
            std::ranges::copy(surface.triangles, static_cast<glm::uvec3*>(indices));
            if (present != nullptr) {
                // Embree hands the pointer on, and the filter only reads.
                rtcSetGeometryUserData(geometry, const_cast<Presence*>(present));
                rtcSetGeometryIntersectFilterFunction(geometry, filter);
                rtcSetGeometryOccludedFilterFunction(geometry, filter);
            }
            rtcCommitGeometry(geometry);
            rtcAttachGeometryByID(scene.get(), geometry, id);
        }
        rtcReleaseGeometry(geometry);
        check();
    }
};

RayScene::RayScene(std::span<const RaySurface> surfaces) {
    float largest = 0;
    for (std::size_t s = 0; s < surfaces.size(); ++s) largest = std::max(largest, check(s, surfaces[s]));
    offset_ = std::ldexp(static_cast<double>(largest), -19);

    // The areas by which boxes are sorted would be 0 in a tiny scene, and every ray would meet every box.
    if (largest > 0 && largest < kSmallestScene) scale_ = std::ldexp(1.0, -std::ilogb(largest));
    embree_ = std::make_unique<Embree>();
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
        if (surfaces[s].triangles.empty()) continue;
        const Presence* present = nullptr;
        if (surfaces[s].present)
            present = presences_.emplace_back(std::make_unique<const Presence>(surfaces[s].present)).get();
        embree_->add(surfaces[s], present, static_cast<unsigned>(s), static_cast<float>(scale_));
    }
    rtcCommitScene(embree_->scene.get());
    embree_->check();
}

RayScene::~RayScene() = default;

std::optional<RayHit> RayScene::intersect(const Ray& ray) const {
    RTCRayHit query{};
    const glm::vec3 origin(scale_ * ray.origin);
    const glm::vec3 direction(ray.direction);
    query.ray.org_x = origin.x;
    query.ray.org_y = origin.y;
    query.ray.org_z = origin.z;
    query.ray.dir_x = direction.x;
    query.ray.dir_y = direction.y;
    query.ray.dir_z = direction.z;
    query.ray.tnear = static_cast<float>(scale_ * ray.nearest);
    query.ray.tfar =
        static_cast<float>(std::min(scale_ * ray.farthest, double{std::numeric_limits<float>::max()}));
    query.ray.mask = ~0U;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(embree_->scene.get(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return RayHit{.surface = query.hit.geomID,
                  .triangle = query.hit.primID,
                  .distance = static_cast<double>(query.ray.tfar) / scale_,
                  .b1 = static_cast<double>(query.hit.u),
                  .b2 = static_cast<double>(query.hit.v)};
}

Ray RayScene::leaving(const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& direction) const {
    const double side = glm::dot(normal, direction) < 0 ? -offset_ : offset_;
    return {.origin = point + side * normal, .direction = direction};
}

bool RayScene::occluded(const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& direction,
                        double farthest) const {
    const double length = end(farthest);
    if (!(length > 0)) return false;
    const glm::vec3 origin(scale_ * leaving(point, normal, direction).origin);
    const glm::vec3 towards(direction);
    RTCRay ray{};
    ray.org_x = origin.x;
    ray.org_y = origin.y;
    ray.org_z = origin.z;
    ray.dir_x = towards.x;
    ray.dir_y = towards.y;
    ray.dir_z = towards.z;
    ray.tfar = static_cast<float>(length);
    ray.mask = ~0U;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(embree_->scene.get(), &context, &ray);
    // Embree marks an occluded ray with a negative length.
    return ray.tfar < 0;
}

std::uint16_t RayScene::occluded(const glm::vec3& origin, const RayBundle& bundle,
                                 std::uint16_t active) const {
    constexpr std::size_t count = RayBundle::kRays;
    RTCRay16 rays{};
    const glm::vec3 start = static_cast<float>(scale_) * origin;
    for (std::size_t i = 0; i < count; ++i) {
        rays.org_x[i] = start.x;
        rays.org_y[i] = start.y;
        rays.org_z[i] = start.z;
        rays.dir_x[i] = bundle.x[i];
        rays.dir_y[i] = bundle.y[i];
        rays.dir_z[i] = bundle.z[i];
        rays.tfar[i] = std::numeric_limits<float>::infinity();
        rays.mask[i] = ~0U;
    }
    return embree_->occluded(rays, active);
}

std::uint16_t RayScene::occluded(const RayPacket& packet, std::uint16_t active) const {
    constexpr std::size_t count = RayPacket::kRays;
    RTCRay16 rays{};
    const auto scale = static_cast<float>(scale_);
    unsigned traced = 0;
    for (std::size_t i = 0; i < count; ++i) {
        rays.org_x[i] = scale * packet.origin_x[i];
        rays.org_y[i] = scale * packet.origin_y[i];
        rays.org_z[i] = scale * packet.origin_z[i];
        rays.dir_x[i] = packet.direction_x[i];
        rays.dir_y[i] = packet.direction_y[i];
        rays.dir_z[i] = packet.direction_z[i];
        rays.tfar[i] = static_cast<float>(end(static_cast<double>(packet.farthest[i])));
        rays.mask[i] = ~0U;
        if (rays.tfar[i] > 0) traced |= active & 1U << i;
    }
    if (traced == 0) return 0;
    return embree_->occluded(rays, traced);
}

double RayScene::end(double farthest) const noexcept {
    return scale_ * ((1 - kLeftOut) * farthest - offset_);
}

}  // namespace nicol
