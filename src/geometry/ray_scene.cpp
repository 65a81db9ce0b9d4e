// SPDX-License-Identifier: MIT
#include "geometry/ray_scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <mutex>
#include <string>
#include <utility>

#include "error.hpp"
#include "geometry/beyond_hit.hpp"
#include "geometry/embree.hpp"
#include "geometry/largest_coordinate.hpp"
#include "geometry/ray_beam.hpp"

namespace nicol {
namespace {

constexpr float kSmallestScene = 1e-6F;

[[noreturn]] void refuse(std::size_t surface, const std::string& message) {
    throw Error(ErrorCode::invalid_argument, "surface " + std::to_string(surface) + ": " + message);
}

/// Checks positions and indices; returns the largest absolute coordinate.
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

// Embree's cache is for subdivision surfaces, of which there are none. Where no memory is left for it,
// NewDevice() keeps a lock of the process, and the next device that is made or released waits forever.
constexpr const char* kDeviceSettings = "tessellation_cache_size=0";

// Returns the device of all scenes, because only scenes of one device can be parts of one scene. It lives as
// long as any of them; null if Embree failed.
std::shared_ptr<embree::Device> shared_device() {
    static std::mutex mutex;
    static std::weak_ptr<embree::Device> shared;
    const std::scoped_lock lock(mutex);
    std::shared_ptr<embree::Device> device = shared.lock();
    if (device) return device;
    const embree::Library& library = embree::library();
    if (embree::Device* const made = library.NewDevice(kDeviceSettings))
        device = {made, library.ReleaseDevice};
    shared = device;
    return device;
}

// Gives a hit the number of its triangle, and the corners of the side that the ray has met.
void renumber(std::span<const TriangleNumbers> numbers, bool from_behind, RayHit& hit) {
    if (numbers.empty()) return;
    const auto after = std::ranges::upper_bound(numbers, hit.triangle, {}, &TriangleNumbers::first);
    const TriangleNumbers& run = *std::prev(after);
    hit.triangle = run.number + (hit.triangle - run.first);
    if (run.back == 0 || !from_behind) return;
    hit.triangle += run.back;
    std::swap(hit.b1, hit.b2);
}

// Returns a ray in Embree's units. scale: RayScene's.
embree::Ray query_of(const Ray& ray, double scale) {
    const glm::vec3 origin(scale * ray.origin), direction(ray.direction);
    const double farthest = std::min(scale * ray.farthest, double{std::numeric_limits<float>::max()});
    embree::Ray query{};
    query.org_x = origin.x;
    query.org_y = origin.y;
    query.org_z = origin.z;
    query.tnear = static_cast<float>(scale * ray.nearest);
    query.dir_x = direction.x;
    query.dir_y = direction.y;
    query.dir_z = direction.z;
    query.tfar = static_cast<float>(farthest);
    query.mask = ~0U;
    return query;
}

}  // namespace

double ray_offset(const std::array<glm::vec3, 3>& corners) {
    const float largest = std::max(
        {largest_coordinate(corners[0]), largest_coordinate(corners[1]), largest_coordinate(corners[2])});
    return kRayOffset * static_cast<double>(largest);
}

Ray leaving(const glm::dvec3& point, const glm::dvec3& normal, const glm::dvec3& direction, double offset) {
    const double side = glm::dot(normal, direction) < 0 ? -offset : offset;
    return {.origin = point + side * normal, .direction = direction};
}

/// Ways through a surface.
struct RayScene::Passage {
    Presence present;
    bool front_only;

    /// Rejects hits at points where rays pass the surface.
    static void filter(const embree::FilterArguments* hits) {
        const auto& surface = *static_cast<const Passage*>(hits->user_data);
        for (unsigned i = 0; i < hits->count; ++i) {
            if (hits->valid[i] == 0) continue;
            const bool blocked =
                (!surface.front_only || hits->meets_front(i)) &&
                (!surface.present || surface.present(hits->triangle(i), hits->u(i), hits->v(i)));
            if (!blocked) hits->valid[i] = 0;
        }
    }
};

struct RayScene::Embree {
    struct Release {
        void operator()(embree::Scene* of) const { embree::library().ReleaseScene(of); }
        void operator()(embree::Geometry* geometry) const { embree::library().ReleaseGeometry(geometry); }
    };
    using GeometryPtr = std::unique_ptr<embree::Geometry, Release>;

    const embree::Library& library = embree::library();
    std::shared_ptr<embree::Device> device = shared_device();
    std::unique_ptr<embree::Scene, Release> scene;

    Embree() {
        if (device) scene.reset(library.NewScene(device.get()));
        check();
        library.SetSceneFlags(scene.get(), embree::kSceneRobust);
    }

    void check() const {
        const int error = library.GetDeviceError(device.get());
        if (error == embree::kErrorNone && scene) return;
        // Embree reports TBB's exception as "unknown" if the system cannot create a thread.
        if (error == embree::kErrorOutOfMemory || error == embree::kErrorUnknown) {
            throw Error(ErrorCode::out_of_memory, "not enough memory for the rays' hierarchy of boxes");
        }
        throw Error(ErrorCode::internal, "Embree failed with error " + std::to_string(error));
    }

    /// Returns the bits of `active` whose rays are occluded. coherent: false for a scene of parts, because
    /// Embree 3.13 never returns from some packets of rays in different directions that meet instances.
    std::uint16_t occluded(embree::Ray16& rays, unsigned active, bool coherent) const {
        constexpr std::size_t count = RayPacket::kRays;
        std::array<int, count> valid{};
        for (std::size_t i = 0; i < count; ++i) valid[i] = (active >> i & 1) != 0 ? -1 : 0;
        library.occluded(scene.get(), valid, rays, coherent);
        unsigned blocked = 0;
        for (std::size_t i = 0; i < count; ++i) blocked |= (rays.tfar[i] < 0 ? 1U : 0U) << i;
        return static_cast<std::uint16_t>(blocked & active);
    }

    void attach(const GeometryPtr& geometry, unsigned id) const {
        library.CommitGeometry(geometry.get());
        library.AttachGeometryByID(scene.get(), geometry.get(), id);
        check();
    }

    /// Adds a surface. `passage` must outlive the scene; null: rays pass nowhere.
    void add(const RaySurface& surface, const Passage* passage, unsigned id, float scale) const {
        const GeometryPtr geometry(library.NewGeometry(device.get(), embree::kTriangleGeometry));
        const std::size_t vertices = surface.positions.size();
        const std::size_t triangles = surface.triangles.size();
        void* positions = library.SetNewGeometryBuffer(geometry.get(), embree::kVertexBuffer, 0,
                                                       embree::kFormatFloat3, sizeof(glm::vec3), vertices);
        void* indices = library.SetNewGeometryBuffer(geometry.get(), embree::kIndexBuffer, 0,
                                                     embree::kFormatUint3, sizeof(glm::uvec3), triangles);
        if (positions == nullptr || indices == nullptr) return check();
        std::ranges::transform(surface.positions, static_cast<glm::vec3*>(positions),
                               [scale](const glm::vec3& p) { return scale * p; });
        std::ranges::copy(surface.triangles, static_cast<glm::uvec3*>(indices));
        if (passage != nullptr) {
            // The const_cast is safe: Embree only passes the pointer on, and the filter only reads.
            library.SetGeometryUserData(geometry.get(), const_cast<Passage*>(passage));
            library.SetGeometryIntersectFilterFunction(geometry.get(), Passage::filter);
            library.SetGeometryOccludedFilterFunction(geometry.get(), Passage::filter);
        }
        attach(geometry, id);
    }

    /// Adds a part, which must outlive the scene.
    void add(const Embree& part, unsigned id) const {
        const GeometryPtr geometry(library.NewGeometry(device.get(), embree::kInstanceGeometry));
        check();
        library.SetGeometryInstancedScene(geometry.get(), part.scene.get());
        attach(geometry, id);
    }

    void commit(std::size_t surfaces) {
        library.CommitScene(scene.get());
        try {
            check();
        } catch (const Error&) {
            // The scene and device are leaked on purpose. A thread that found no memory may stay bound to the
            // scene's allocator; if that were freed, the next allocator at its address would hand out freed
            // blocks. The large part, the geometry, is released.
            for (unsigned id = 0; id < surfaces; ++id) library.DetachGeometry(scene.get(), id);
            static_cast<void>(scene.release());
            library.RetainDevice(device.get());
            throw;
        }
    }
};

RayScene::RayScene(std::span<const RaySurface> surfaces) {
    float largest = 0;
    for (std::size_t s = 0; s < surfaces.size(); ++s) largest = std::max(largest, check(s, surfaces[s]));
    // Scaling is needed because the box areas that sort the hierarchy would be 0 in a tiny scene, and every
    // ray would meet every box.
    if (largest > 0 && largest < kSmallestScene) scale_ = std::ldexp(1.0, -std::ilogb(largest));
    embree_ = std::make_unique<Embree>();
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
        numbers_.emplace_back(surfaces[s].numbers.begin(), surfaces[s].numbers.end());
        if (surfaces[s].triangles.empty()) continue;
        const Passage* passage = nullptr;
        if (surfaces[s].present || surfaces[s].front_only) {
            passage = passages_
                          .emplace_back(std::make_unique<const Passage>(
                              Passage{.present = surfaces[s].present, .front_only = surfaces[s].front_only}))
                          .get();
        }
        embree_->add(surfaces[s], passage, static_cast<unsigned>(s), static_cast<float>(scale_));
    }
    embree_->commit(surfaces.size());
}

RayScene::RayScene(std::vector<RayPart> parts)
    : parts_(std::move(parts)), embree_(std::make_unique<Embree>()) {
    for (std::size_t p = 0; p < parts_.size(); ++p) {
        numbers_.push_back(std::move(parts_[p].numbers));
        embree_->add(*parts_[p].scene->embree_, static_cast<unsigned>(p));
    }
    embree_->commit(parts_.size());
}

RayScene::~RayScene() = default;

std::optional<RayHit> RayScene::intersect(const Ray& ray) const {
    embree::RayHit query{};
    query.ray = query_of(ray, scale_);
    query.hit.geometry = query.hit.instance = embree::kNoGeometry;
    embree_->library.intersect(embree_->scene.get(), query);
    return hit_of(query.hit, query.ray.tfar, ray);
}

void RayScene::intersect(std::span<const Ray> rays, std::span<std::optional<RayHit>> hits) const {
    constexpr std::size_t most = embree::Ray16::kRays;
    for (std::size_t first = 0; first < rays.size(); first += most) {
        const std::span<const Ray> some = rays.subspan(first, std::min(most, rays.size() - first));
        embree::RayHit16 query{};
        std::array<int, most> valid{};
        for (std::size_t i = 0; i < some.size(); ++i) {
            query.ray.set(i, query_of(some[i], scale_));
            valid[i] = -1;
        }
        query.geometry.fill(embree::kNoGeometry);
        query.instance.fill(embree::kNoGeometry);
        embree_->library.intersect(embree_->scene.get(), valid, query, parts_.empty() && is_beam(some));
        for (std::size_t i = 0; i < some.size(); ++i)
            hits[first + i] = hit_of(query.hit(i), query.ray.tfar[i], some[i]);
    }
}

std::uint16_t RayScene::intersect(const RayPacket& packet, std::uint16_t active, HitPacket& hits) const {
    if (active == 0) return 0;
    constexpr std::size_t count = RayPacket::kRays;
    const auto scale = static_cast<float>(scale_);
    embree::RayHit16 query{};
    std::array<int, count> valid;
    for (std::size_t i = 0; i < count; ++i) {
        query.ray.org_x[i] = scale * packet.origin_x[i];
        query.ray.org_y[i] = scale * packet.origin_y[i];
        query.ray.org_z[i] = scale * packet.origin_z[i];
        query.ray.tfar[i] = scale * packet.farthest[i];
        valid[i] = (active >> i & 1) != 0 ? -1 : 0;
    }
    query.ray.dir_x = packet.direction_x;
    query.ray.dir_y = packet.direction_y;
    query.ray.dir_z = packet.direction_z;
    query.ray.mask.fill(~0U);
    query.geometry.fill(embree::kNoGeometry);
    query.instance.fill(embree::kNoGeometry);
    embree_->library.intersect(embree_->scene.get(), valid, query, parts_.empty() && is_beam(packet, active));
    hits = {.distance = query.ray.tfar,
            .b1 = query.u,
            .b2 = query.v,
            .surface = parts_.empty() ? query.geometry : query.instance,
            .triangle = query.triangle};
    for (float& distance : hits.distance) distance /= scale;
    unsigned found = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (query.geometry[i] == embree::kNoGeometry) continue;
        found |= 1U << i;
        if (numbers_[hits.surface[i]].empty()) continue;
        const Ray ray{.direction = {packet.direction_x[i], packet.direction_y[i], packet.direction_z[i]}};
        const RayHit hit = hit_of(query.hit(i), query.ray.tfar[i], ray).value();
        hits.triangle[i] = hit.triangle;
        hits.b1[i] = static_cast<float>(hit.b1);
        hits.b2[i] = static_cast<float>(hit.b2);
    }
    return static_cast<std::uint16_t>(found);
}

std::optional<RayHit> RayScene::hit_of(const embree::Hit& found, float length, const Ray& ray) const {
    if (found.geometry == embree::kNoGeometry) return std::nullopt;
    RayHit hit{.surface = parts_.empty() ? found.geometry : found.instance,
               .triangle = found.triangle,
               .distance = static_cast<double>(length) / scale_,
               .b1 = static_cast<double>(found.u),
               .b2 = static_cast<double>(found.v)};
    const glm::vec3 normal(found.ng_x, found.ng_y, found.ng_z);
    renumber(numbers_[hit.surface], glm::dot(normal, glm::vec3(ray.direction)) > 0, hit);
    return hit;
}

bool RayScene::occluded(const Ray& ray) const {
    const double length = end(glm::vec3(ray.origin), ray.farthest);
    if (!(length > 0)) return false;
    embree::Ray query = query_of(ray, scale_);
    query.tnear = 0;  // the ray begins at its origin
    query.tfar = static_cast<float>(length);
    embree_->library.occluded(embree_->scene.get(), query);
    // Embree marks an occluded ray with a negative length.
    return query.tfar < 0;
}

std::uint16_t RayScene::occluded(const glm::vec3& origin, const RayBundle& bundle,
                                 std::uint16_t active) const {
    constexpr std::size_t count = RayBundle::kRays;
    embree::Ray16 rays{};
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
    // Rays from one point spread, so that one beam of them meets most boxes of a fine mesh around the point.
    return embree_->occluded(rays, active, false);
}

std::uint16_t RayScene::occluded(const RayPacket& packet, std::uint16_t active) const {
    constexpr std::size_t count = RayPacket::kRays;
    embree::Ray16 rays{};
    const auto scale = static_cast<float>(scale_);
    unsigned traced = 0;
    for (std::size_t i = 0; i < count; ++i) {
        rays.org_x[i] = scale * packet.origin_x[i];
        rays.org_y[i] = scale * packet.origin_y[i];
        rays.org_z[i] = scale * packet.origin_z[i];
        rays.dir_x[i] = packet.direction_x[i];
        rays.dir_y[i] = packet.direction_y[i];
        rays.dir_z[i] = packet.direction_z[i];
        const glm::vec3 origin(packet.origin_x[i], packet.origin_y[i], packet.origin_z[i]);
        rays.tfar[i] = static_cast<float>(end(origin, static_cast<double>(packet.farthest[i])));
        rays.mask[i] = ~0U;
        if (rays.tfar[i] > 0) traced |= active & 1U << i;
    }
    if (traced == 0) return 0;
    return embree_->occluded(rays, traced, parts_.empty());
}

double RayScene::end(const glm::vec3& origin, double farthest) const noexcept {
    return scale_ * before_light(farthest, static_cast<double>(largest_coordinate(origin)));
}

}  // namespace nicol
