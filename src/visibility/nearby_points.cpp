// SPDX-License-Identifier: MIT
#include "visibility/nearby_points.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "geometry/largest_coordinate.hpp"
#include "geometry/position_hash.hpp"

namespace nicol {
namespace {

// Number of cells along the largest coordinate.
constexpr float kCellsAcross = 0x1p14F;
// Largest difference of places, relative to the largest coordinate.
constexpr float kRounding = 0x1p-21F;

}  // namespace

NearbyPoints::NearbyPoints(const TracedPoints& points) {
    for (std::size_t i = 0; i < points.size(); ++i)
        size_ = std::max(size_, largest_coordinate(points.origin(i)));
    places_.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        places_.try_emplace(key_of(points.origin(i), points.normal(i)), static_cast<std::uint32_t>(i));
}

std::optional<std::size_t> NearbyPoints::find(const TracedPoints& points, const glm::vec3& origin,
                                              const glm::vec3& normal) const {
    const std::uint32_t* const place = places_.find(key_of(origin, normal));
    if (place == nullptr || points.normal(*place) != normal) return std::nullopt;
    if (!(glm::distance(points.origin(*place), origin) <= kRounding * size_)) return std::nullopt;
    return *place;
}

std::size_t NearbyPoints::key_of(const glm::vec3& origin, const glm::vec3& normal) const {
    return geometry::hash_of(glm::round(origin * (kCellsAcross / std::max(size_, 1e-30F))), normal);
}

}  // namespace nicol
