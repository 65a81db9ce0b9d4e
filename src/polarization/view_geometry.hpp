// SPDX-License-Identifier: MIT
// Directions and frames of camera and surface, written once for single numbers and for vectors of lanes.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace nicol {

/// Vector of three Numbers. Number is float, double or a vector of them (with no attribute but its size).
/// Functions on Vector3 are inlined into loops of every instruction set and return no bare vectors.
template <class Number>
struct Vector3 {
    Number x, y, z;
};

/// Axes and position of a Viewpoint.
struct CameraAxes {
    double perspective;  ///< 1, or 0 for an orthographic camera
    Vector3<double> eye, backward, up, right;
};

/// Sets each lane to `number`.
template <class Number, class Real>
[[gnu::always_inline]] inline void fill(Number& lanes, const Real& number) {
    if constexpr (std::is_floating_point_v<Number>) {
        lanes = static_cast<Number>(number);
    } else {
        lanes = Number{} + number;
    }
}

template <class Number>
[[gnu::always_inline]] inline void square_root(Number& x) {
    if constexpr (std::is_floating_point_v<Number>) {
        x = std::sqrt(x);
    } else {
        using Element = std::remove_cvref_t<decltype(x[0])>;
        for (std::size_t i = 0; i < sizeof(Number) / sizeof(Element); ++i) x[i] = std::sqrt(x[i]);
    }
}

[[gnu::always_inline]] inline Vector3<float> in_floats(const Vector3<double>& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

template <class A, class B, class Number>
[[gnu::always_inline]] inline void dot(const Vector3<A>& a, const Vector3<B>& b, Number& out) {
    out = a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class A, class B>
[[gnu::always_inline]] inline auto cross(const Vector3<A>& a, const Vector3<B>& b) {
    return Vector3<decltype(A{} * B{})>{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Returns a - factor b.
template <class Number>
[[gnu::always_inline]] inline Vector3<Number> minus_scaled(const Vector3<Number>& a, const Number& factor,
                                                           const Vector3<Number>& b) {
    return {a.x - factor * b.x, a.y - factor * b.y, a.z - factor * b.z};
}

/// Returns v divided by its length, or `fallback` where the squared length is at most `least`.
template <class Number, class Fallback>
[[gnu::always_inline]] inline Vector3<Number> normalized_or(const Vector3<Number>& v, float least,
                                                            const Vector3<Fallback>& fallback) {
    Number length;
    dot(v, v, length);
    const auto defined = length > least;
    length = defined ? length : Number{} + 1.0F;
    square_root(length);
    const Number inverse = 1.0F / length;
    Vector3<Number> other;
    fill(other.x, fallback.x);
    fill(other.y, fallback.y);
    fill(other.z, fallback.z);
    return {defined ? v.x * inverse : other.x, defined ? v.y * inverse : other.y,
            defined ? v.z * inverse : other.z};
}

/// Returns the unit vector from a point of the scene to the camera, which is the propagation of the light
/// that the pixel receives. A point at the camera itself counts as a point straight ahead.
template <class Number>
[[gnu::always_inline]] inline Vector3<Number> towards_camera(const CameraAxes& camera,
                                                             const Vector3<Number>& point) {
    const Vector3<Number> way{camera.perspective * (camera.eye.x - point.x),
                              camera.perspective * (camera.eye.y - point.y),
                              camera.perspective * (camera.eye.z - point.z)};
    return normalized_or(way, 0.0F, camera.backward);
}

/// Returns the x axis of the camera's frame field at a unit propagation z (Eq. 83), not normalized. The axis
/// is up x z, as in Mitsuba 3, or `right` straight above and below the camera, where up x z is undefined.
template <class Real, class Number>
[[gnu::always_inline]] inline Vector3<Number> camera_x(const Vector3<Real>& up, const Vector3<Real>& right,
                                                       const Vector3<Number>& z) {
    const Vector3<Number> x = cross(up, z);
    Number number;
    dot(x, x, number);
    const auto defined = number > 1e-12F;
    Vector3<Number> other;
    fill(other.x, right.x);
    fill(other.y, right.y);
    fill(other.z, right.z);
    const Vector3<Number> chosen{defined ? x.x : other.x, defined ? x.y : other.y, defined ? x.z : other.z};
    dot(chosen, z, number);
    return minus_scaled(chosen, number, z);
}

/// theta_phi_frame() of a unit vector: x = (z cos phi, z sin phi, -rho) and y = (-sin phi, cos phi, 0).
template <class Number>
struct ThetaPhiFrame {
    Number cos_phi, sin_phi;
    Number rho;  ///< distance from the z axis
    Vector3<Number> direction;
};

template <class Number>
[[gnu::always_inline]] inline ThetaPhiFrame<Number> theta_phi_axes(const Vector3<Number>& direction) {
    Number rho = direction.x * direction.x + direction.y * direction.y;
    square_root(rho);
    const auto tilted = rho > 0.0F;
    const Number inverse = 1.0F / (tilted ? rho : Number{} + 1.0F);
    return {tilted ? direction.x * inverse : Number{} + 1.0F, direction.y * inverse, rho, direction};
}

/// Returns the components of v along the axes of the frame.
template <class Number>
[[gnu::always_inline]] inline Vector3<Number> in_frame(const ThetaPhiFrame<Number>& f,
                                                       const Vector3<Number>& v) {
    Number along;
    dot(f.direction, v, along);
    return {f.direction.z * (f.cos_phi * v.x + f.sin_phi * v.y) - f.rho * v.z,
            f.cos_phi * v.y - f.sin_phi * v.x, along};
}

}  // namespace nicol
