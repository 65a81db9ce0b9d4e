// SPDX-License-Identifier: MIT
// Frames of sixteen surfaces.
#pragma once

#include <cstddef>

#include "polarization/lane_points.hpp"

namespace nicol {

/// Orthogonal unit axes; z is the normal.
struct LaneFrames {
    LaneVectors x, y, z;
};

/// Computes the components of vectors along the axes. `out` may be `vectors`.
void into_frames(const LaneFrames& frames, const LaneVectors& vectors, LaneVectors& out);
/// Computes the vectors that have these components. `out` may be `components`.
void out_of_frames(const LaneFrames& frames, const LaneVectors& components, LaneVectors& out);

/// Returns the components of a vector in the lanes from `first` on.
template <class Number>
[[gnu::always_inline]] inline Vector3<Number> along(const LaneFrames& frames, std::size_t first,
                                                    const Vector3<Number>& v) {
    Vector3<Number> axis, out;
    load_part(frames.x, first, axis);
    dot(axis, v, out.x);
    load_part(frames.y, first, axis);
    dot(axis, v, out.y);
    load_part(frames.z, first, axis);
    dot(axis, v, out.z);
    return out;
}

/// Computes unit vectors orthogonal to the unit vector n and to each other by Duff et al. 2017, which needs
/// neither a root nor a branch.
template <class Number>
[[gnu::always_inline]] inline void some_axes(const Vector3<Number>& n, Vector3<Number>& x,
                                             Vector3<Number>& y) {
    const Number sign = n.z < 0.0F ? Number{} - 1.0F : Number{} + 1.0F;
    const Number a = -1.0F / (sign + n.z);
    const Number b = n.x * n.y * a;
    x = {1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x};
    y = {b, sign + n.y * n.y * a, -n.y};
}

}  // namespace nicol
