// SPDX-License-Identifier: MIT
// Search for points of an object that was shifted, whose places are rounded in another way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "geometry/key_table.hpp"
#include "visibility/traced_points.hpp"

namespace nicol {

/// Table of traced points by normal and by cells of space.
class NearbyPoints {
public:
    NearbyPoints() = default;
    explicit NearbyPoints(const TracedPoints& points);

    /// Returns the index of a point with equal normal whose place differs as by rounding. May miss a point,
    /// such as one at the border of a cell. points: those that the table was made for.
    [[nodiscard]] std::optional<std::size_t> find(const TracedPoints& points, const glm::vec3& origin,
                                                  const glm::vec3& normal) const;

private:
    [[nodiscard]] std::size_t key_of(const glm::vec3& origin, const glm::vec3& normal) const;

    float size_ = 0;  // largest coordinate
    KeyTable<std::uint32_t> places_;
};

}  // namespace nicol
