// SPDX-License-Identifier: MIT
// Points and directions of sixteen vertices side by side.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "polarization/view_geometry.hpp"
#include "simd/lane_parts.hpp"
#include "simd/lane_phases.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// Single-precision vectors of sixteen vertices.
struct LaneVectors {
    Lanes x, y, z;
};

inline void put(LaneVectors& lanes, std::size_t i, const glm::vec3& v) {
    lanes.x[i] = v.x;
    lanes.y[i] = v.y;
    lanes.z[i] = v.z;
}

/// Returns the vector of a lane.
[[nodiscard]] inline glm::vec3 vector_at(const LaneVectors& lanes, std::size_t i) {
    return {lanes.x[i], lanes.y[i], lanes.z[i]};
}

[[gnu::always_inline]] inline Vector3<float> components(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}
[[gnu::always_inline]] inline Vector3<double> components(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

/// Loads the part that begins at lane `first`.
template <class Number>
[[gnu::always_inline]] inline void load_part(const LaneVectors& from, std::size_t first,
                                             Vector3<Number>& to) {
    load_part(from.x, first, to.x);
    load_part(from.y, first, to.y);
    load_part(from.z, first, to.z);
}
template <class Number>
[[gnu::always_inline]] inline void store_part(const Vector3<Number>& from, std::size_t first,
                                              LaneVectors& to) {
    store_part(from.x, first, to.x);
    store_part(from.y, first, to.y);
    store_part(from.z, first, to.z);
}

/// Double-precision vectors of sixteen vertices, for steps in which single precision loses too many digits.
struct LanePoints {
    DoubleLanes x, y, z;
};

/// Returns the points side by side. `from` has at most sixteen points; lanes beyond them repeat the first
/// point.
[[nodiscard]] LanePoints lane_points(std::span<const glm::vec3> from);

}  // namespace nicol
