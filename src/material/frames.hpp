// SPDX-License-Identifier: MIT
// Rotations from s-frames (x along the s-axis) to the theta-phi frames of Material, without trigonometric
// functions. Written once for single numbers and for vectors of lanes.
#pragma once

#include <cstddef>

#include "polarization/fresnel.hpp"
#include "polarization/mueller.hpp"
#include "polarization/view_geometry.hpp"
#include "simd/number.hpp"

namespace nicol {

/// Rotations about z from s-frames (x along the s-axis) to the theta-phi frames of the incident propagation
/// -light and of the outgoing propagation `viewer`, each as cosine and sine of twice the angle.
template <class Number>
struct SurfaceRotations {
    Number in_cos2, in_sin2;
    Number out_cos2, out_sin2;
};

/// Returns a in the lanes where `condition` holds, else b.
template <class Condition, class Number>
[[gnu::always_inline]] inline Vector3<Number> choose(const Condition& condition, const Vector3<Number>& a,
                                                     const Vector3<Number>& b) {
    return {condition ? a.x : b.x, condition ? a.y : b.y, condition ? a.z : b.z};
}

/// Computes the rotation from x along the unit vector s, perpendicular to `direction`, to theta-hat.
/// `upwards` is 1 for propagation along `direction` and -1 for propagation against `direction`.
template <class Number>
[[gnu::always_inline]] inline void rotation_from_s(const Vector3<Number>& s, const Vector3<Number>& direction,
                                                   float upwards, Number& cos2, Number& sin2) {
    const Number rho2 = direction.x * direction.x + direction.y * direction.y;
    // Smaller squares are denormal numbers. Such a direction is along z, and theta-hat along x.
    constexpr ScalarOf<Number> least = threshold<Number>(1e-37F, 1e-280);
    const auto tilted = rho2 > least;
    const Number cosine = tilted ? -s.z : upwards * s.x;
    const Number sine = tilted ? upwards * (direction.y * s.x - direction.x * s.y) : -s.y;
    const Number norm = cosine * cosine + sine * sine;
    const Number inverse = 1.0F / (norm > least ? norm : Number{} + 1.0F);
    cos2 = (cosine * cosine - sine * sine) * inverse;
    sin2 = 2.0F * cosine * sine * inverse;
}

/// Returns the rotations for x along light x viewer, which is the s-axis of a facet between these unit
/// vectors. For parallel vectors, x is phi-hat.
template <class Number>
[[gnu::always_inline]] inline SurfaceRotations<Number> rotations_from_s_frames(
    const Vector3<Number>& light, const Vector3<Number>& viewer) {
    // The s-axis is the cross product of one vector with the difference or sum of both, which stays accurate
    // for nearly parallel directions. The vector nearer to the normal is used, because otherwise the z of s
    // would be a difference of large numbers. The sign of s does not matter.
    Number number;
    dot(light, viewer, number);
    const auto alike = number > 0.0F;
    const Vector3<Number> difference{viewer.x - light.x, viewer.y - light.y, viewer.z - light.z};
    const Vector3<Number> sum{viewer.x + light.x, viewer.y + light.y, viewer.z + light.z};
    const Number light_rho2 = light.x * light.x + light.y * light.y;
    const Number viewer_rho2 = viewer.x * viewer.x + viewer.y * viewer.y;
    const Vector3<Number> s =
        cross(choose(light_rho2 < viewer_rho2, light, viewer), choose(alike, difference, sum));

    // Any difference defines s in double precision, because next to the normal the azimuths of two directions
    // differ even if the directions are very close to each other.
    dot(s, s, number);
    const auto defined = number > threshold<Number>(1e-24F, 1e-280);
    number = defined ? number : Number{} + 1.0F;
    square_root(number);
    const Number inverse = 1.0F / number;
    const Vector3<Number> unit{s.x * inverse, s.y * inverse, s.z * inverse};
    SurfaceRotations<Number> out;
    rotation_from_s(unit, light, -1.0F, out.in_cos2, out.in_sin2);
    rotation_from_s(unit, viewer, 1.0F, out.out_cos2, out.out_sin2);
    // Parallel directions have s along phi-hat.
    out.in_cos2 = defined ? out.in_cos2 : Number{} - 1.0F;
    out.in_sin2 = defined ? out.in_sin2 : Number{};
    out.out_cos2 = defined ? out.out_cos2 : Number{} - 1.0F;
    out.out_sin2 = defined ? out.out_sin2 : Number{};
    return out;
}

/// Computes the elements of scale times the block in rotated frames: calls put(4 row + column, element) for
/// all columns, or only for the first column if `columns` is 1.
template <class Number, class Put>
[[gnu::always_inline]] inline void in_rotated_frames(const Number& scale,
                                                     const ReflectionBlock<Number>& block,
                                                     const SurfaceRotations<Number>& rotations,
                                                     std::size_t columns, const Put& put) {
    const Number a = scale * block.a;
    const Number b = scale * block.b;
    const auto& [ci, si, co, so] = rotations;
    put(0, a);
    put(4, co * b);
    put(8, -so * b);
    put(12, Number{});
    if (columns == 1) return;
    const Number c = scale * block.c;
    const Number d = scale * block.d;
    put(1, b * ci);
    put(2, -b * si);
    put(3, Number{});
    put(5, co * ci * a + so * si * c);
    put(6, so * ci * c - co * si * a);
    put(7, -so * d);
    put(9, co * si * c - so * ci * a);
    put(10, co * ci * c + so * si * a);
    put(11, -co * d);
    put(13, d * si);
    put(14, d * ci);
    put(15, c);
}

/// Returns the rotations of one pair of unit vectors.
[[nodiscard]] SurfaceRotations<double> rotations_from_s_frames(const glm::dvec3& light,
                                                               const glm::dvec3& viewer);

/// Returns m in rotated frames.
[[nodiscard]] Mueller in_rotated_frames(const Mueller& m, const SurfaceRotations<double>& rotations);

/// Returns scale times the block in rotated frames.
[[nodiscard]] Mueller in_rotated_frames(double scale, const ReflectionBlock<double>& block,
                                        const SurfaceRotations<double>& rotations);

}  // namespace nicol
