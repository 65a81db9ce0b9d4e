// SPDX-License-Identifier: MIT
#include "surfaces/surface_rays.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "surfaces/glass_crossings.hpp"

namespace nicol {
namespace {

using Blocker = SceneGeometry::Blocker;

std::vector<TriangleNumbers> numbers_of(std::span<const Blocker* const> blockers) {
    std::vector<TriangleNumbers> out;
    std::size_t first = 0;
    for (const Blocker* blocker : blockers) {
        out.push_back({.first = static_cast<std::uint32_t>(first),
                       .number = static_cast<std::uint32_t>(blocker->first_triangle),
                       .back = blocker->two_sided ? static_cast<std::uint32_t>(blocker->triangles) : 0});
        first += blocker->triangles;
    }
    return out;
}

std::size_t triangles_of(std::span<const Blocker* const> blockers) {
    std::size_t out = 0;
    for (const Blocker* blocker : blockers) out += blocker->triangles;
    return out;
}

std::shared_ptr<const RayScene> rays_of(const WorldGeometry& geometry,
                                        std::span<const Blocker* const> blockers) {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    triangles.reserve(triangles_of(blockers));
    for (const Blocker* blocker : blockers) {
        const auto shift =
            static_cast<std::uint32_t>(positions.size()) - static_cast<std::uint32_t>(blocker->first);
        const auto points =
            std::span(geometry.positions).subspan(blocker->first, blocker->last - blocker->first);
        positions.insert(positions.end(), points.begin(), points.end());
        for (const glm::uvec3& corners :
             std::span(geometry.triangles).subspan(blocker->first_triangle, blocker->triangles))
            triangles.push_back(corners + shift);
    }
    const std::vector<TriangleNumbers> numbers = numbers_of(blockers);
    const RaySurface surface{.positions = positions,
                             .triangles = triangles,
                             .present = presence_of(geometry, numbers, triangles.size()),
                             .numbers = numbers};
    return std::make_shared<const RayScene>(std::span(&surface, 1));
}

}  // namespace

std::shared_ptr<const RayScene> SurfaceRays::get() {
    if (!rays_) rays_ = released_.lock();
    if (rays_ && version_ == surfaces_.version()) return rays_;
    rays_.reset();
    std::vector<const Blocker*> all;
    std::map<std::pair<Version, std::uint32_t>, std::vector<const Blocker*>> batches;
    bool together = true;
    for (const Blocker& blocker : surfaces_.blockers()) {
        all.push_back(&blocker);
        batches[{blocker.placed, blocker.batch}].push_back(&blocker);
        together = together && blocker.placed == all.front()->placed;
    }
    std::map<PartKey, std::shared_ptr<const RayScene>> parts;
    std::vector<RayPart> list;
    bool scaled = false;
    if (!together) {
        for (const auto& [key, blockers] : batches) {
            const PartKey part_key{key.first, key.second, triangles_of(blockers)};
            std::shared_ptr<const RayScene>& part = parts[part_key];
            const auto known = parts_.find(part_key);
            part = known != parts_.end() ? known->second : rays_of(surfaces_.geometry(), blockers);
            list.push_back({.scene = part, .numbers = numbers_of(blockers)});
            scaled = scaled || part->scaled();
        }
    }
    const bool flat = together || scaled;
    rays_ = flat ? rays_of(surfaces_.geometry(), all) : std::make_shared<const RayScene>(std::move(list));
    parts_ = flat ? decltype(parts_){} : std::move(parts);
    version_ = surfaces_.version();
    return rays_;
}

std::shared_ptr<const BakeGlass> SurfaceRays::glass() {
    if (glass_version_ != surfaces_.version()) {
        glass_ = glass_of(surfaces_.shared_geometry());
        glass_version_ = surfaces_.version();
    }
    return glass_;
}

}  // namespace nicol
