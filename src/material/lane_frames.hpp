// SPDX-License-Identifier: MIT
// The rotations of frames.hpp at sixteen pairs of directions, in single precision.
#pragma once

#include "polarization/view_geometry.hpp"

namespace nicol {

template <class Number>
struct LaneRotations {
    Number in_cos2, in_sin2;
    Number out_cos2, out_sin2;
};

/// a where `condition` holds, else b.
template <class Condition, class Number>
[[gnu::always_inline]] inline Vector3<Number> choose(const Condition& condition, const Vector3<Number>& a,
                                                     const Vector3<Number>& b) {
    return {condition ? a.x : b.x, condition ? a.y : b.y, condition ? a.z : b.z};
}

/// From x along the unit s, across `direction`, to theta-hat; `upwards`: 1 for a propagation along
/// `direction`, -1 for one against it.
template <class Number>
[[gnu::always_inline]] inline void rotation_from_s(const Vector3<Number>& s, const Vector3<Number>& direction,
                                                   float upwards, Number& cos2, Number& sin2) {
    const Number rho2 = direction.x * direction.x + direction.y * direction.y;
    // Else the direction is along z, and theta-hat along x. Smaller squares are denormal.
    const auto tilted = rho2 > 1e-37F;
    const Number cosine = tilted ? -s.z : upwards * s.x;
    const Number sine = tilted ? upwards * (direction.y * s.x - direction.x * s.y) : -s.y;
    const Number norm = cosine * cosine + sine * sine;
    const Number inverse = 1.0F / (norm > 1e-37F ? norm : Number{} + 1.0F);
    cos2 = (cosine * cosine - sine * sine) * inverse;
    sin2 = 2.0F * cosine * sine * inverse;
}

/// rotations_from_s_frames() of unit directions above the horizon.
template <class Number>
[[gnu::always_inline]] inline LaneRotations<Number> lane_rotations(const Vector3<Number>& light,
                                                                   const Vector3<Number>& viewer) {
    // The product of one of the two and a difference that is small where they are nearly parallel. Of the one
    // nearer to the normal, or else the z of s would be a difference of large numbers. Its sign is of no
    // matter.
    Number number;
    dot(light, viewer, number);
    const auto alike = number > 0.0F;
    const Vector3<Number> difference{viewer.x - light.x, viewer.y - light.y, viewer.z - light.z};
    const Vector3<Number> sum{viewer.x + light.x, viewer.y + light.y, viewer.z + light.z};
    const Number light_rho2 = light.x * light.x + light.y * light.y;
    const Number viewer_rho2 = viewer.x * viewer.x + viewer.y * viewer.y;
    const Vector3<Number> s =
        cross(choose(light_rho2 < viewer_rho2, light, viewer), choose(alike, difference, sum));

    dot(s, s, number);
    const auto defined = number > 1e-24F;
    number = defined ? number : Number{} + 1.0F;
    square_root(number);
    const Number inverse = 1.0F / number;
    const Vector3<Number> unit{s.x * inverse, s.y * inverse, s.z * inverse};
    LaneRotations<Number> out;
    rotation_from_s(unit, light, -1.0F, out.in_cos2, out.in_sin2);
    rotation_from_s(unit, viewer, 1.0F, out.out_cos2, out.out_sin2);
    // Parallel directions: s along phi-hat.
    out.in_cos2 = defined ? out.in_cos2 : Number{} - 1.0F;
    out.in_sin2 = defined ? out.in_sin2 : Number{};
    out.out_cos2 = defined ? out.out_cos2 : Number{} - 1.0F;
    out.out_sin2 = defined ? out.out_sin2 : Number{};
    return out;
}

}  // namespace nicol
