// SPDX-License-Identifier: MIT
// Matrices of two rows and two columns, written for vectors of lanes.
#pragma once

#include "polarization/view_geometry.hpp"

namespace nicol {

template <class Number>
struct Vector2 {
    Number x, y;
};

/// Columns of a matrix.
template <class Number>
struct Matrix2 {
    Vector2<Number> first, second;
};

template <class Number>
[[gnu::always_inline]] inline Vector2<Number> times(const Matrix2<Number>& m, const Vector2<Number>& v) {
    return {m.first.x * v.x + m.second.x * v.y, m.first.y * v.x + m.second.y * v.y};
}

template <class Number>
[[gnu::always_inline]] inline Matrix2<Number> times(const Matrix2<Number>& a, const Matrix2<Number>& b) {
    return {times(a, b.first), times(a, b.second)};
}

template <class Number>
[[gnu::always_inline]] inline Matrix2<Number> transposed(const Matrix2<Number>& m) {
    return {{m.first.x, m.second.x}, {m.first.y, m.second.y}};
}

/// Returns a where the condition holds, else b.
template <class Condition, class Number>
[[gnu::always_inline]] inline Matrix2<Number> choose(const Condition& condition, const Matrix2<Number>& a,
                                                     const Matrix2<Number>& b) {
    return {{condition ? a.first.x : b.first.x, condition ? a.first.y : b.first.y},
            {condition ? a.second.x : b.second.x, condition ? a.second.y : b.second.y}};
}

/// Computes the determinant.
template <class Number>
[[gnu::always_inline]] inline void determinant(const Matrix2<Number>& m, Number& out) {
    out = m.first.x * m.second.y - m.first.y * m.second.x;
}

/// Computes the sum of the squared elements.
template <class Number>
[[gnu::always_inline]] inline void squares(const Matrix2<Number>& m, Number& out) {
    out = m.first.x * m.first.x + m.first.y * m.first.y + m.second.x * m.second.x + m.second.y * m.second.y;
}

/// Returns the rotation or reflection that is nearest to a matrix; any of them for a matrix of zeros.
template <class Number>
[[gnu::always_inline]] inline Matrix2<Number> nearest_orthogonal(const Matrix2<Number>& m) {
    Number sign;
    determinant(m, sign);
    sign = sign > 0.0F ? Number{} + 1.0F : Number{} - 1.0F;
    const Vector3<Number> axis{m.first.x + sign * m.second.y, m.first.y - sign * m.second.x, Number{}};
    const Vector3<Number> unit = normalized_or(axis, 0.0F, Vector3<float>{1, 0, 0});
    return {{unit.x, unit.y}, {-sign * unit.y, sign * unit.x}};
}

/// Returns the square root of a covariance that is nearest to a matrix.
template <class Number>
[[gnu::always_inline]] inline Matrix2<Number> root_near(const Matrix2<Number>& covariance,
                                                        const Matrix2<Number>& near) {
    Number area;
    determinant(covariance, area);
    area = area > 0.0F ? area : Number{};
    square_root(area);
    Number trace = covariance.first.x + covariance.second.y + 2.0F * area;
    square_root(trace);
    const auto some = trace > 0.0F;
    const Number inverse = some ? 1.0F / (some ? trace : Number{} + 1.0F) : Number{};
    const Number xy = inverse * covariance.first.y;
    const Matrix2<Number> root{{inverse * (covariance.first.x + area), xy},
                               {xy, inverse * (covariance.second.y + area)}};
    // The root's inverse times its determinant.
    const Matrix2<Number> turned{{root.second.y, -xy}, {-xy, root.first.x}};
    return times(root, nearest_orthogonal(times(turned, near)));
}

/// Returns cosine and sine of the rotation of with_orthogonal_columns(). of_longer, of_shorter: squared
/// lengths of the columns. product: their scalar product.
template <class Number>
[[gnu::always_inline]] inline Vector2<Number> rotation_of_columns(const Number& of_longer,
                                                                  const Number& of_shorter,
                                                                  const Number& product) {
    constexpr float almost = 0.02F;
    // Cosine and sine of twice the angle of the rotation.
    const Vector3<Number> twice = normalized_or(
        Vector3<Number>{of_longer - of_shorter + almost * (of_longer + of_shorter), 2.0F * product, Number{}},
        0.0F, Vector3<float>{1, 0, 0});
    Number cosine = 0.5F + 0.5F * twice.x;
    square_root(cosine);
    return {cosine, 0.5F * twice.y / cosine};
}

/// Computes the squared length of the first column of with_orthogonal_columns().
template <class Number>
[[gnu::always_inline]] inline void longer_column(const Number& of_first, const Number& of_second,
                                                 const Number& product, Number& out) {
    const Number of_longer = of_first < of_second ? of_second : of_first;
    const Number of_shorter = of_first < of_second ? of_first : of_second;
    const Vector2<Number> by = rotation_of_columns(of_longer, of_shorter, product);
    out = by.x * by.x * of_longer + by.y * (2.0F * by.x * product + by.y * of_shorter);
}

/// Returns a matrix times the rotation that makes the columns orthogonal and the first one longer, which
/// keeps the product with the transpose. Columns of almost the same length that are almost orthogonal keep
/// their directions, because rounding errors would decide between the rotations.
template <class Number>
[[gnu::always_inline]] inline Matrix2<Number> with_orthogonal_columns(const Matrix2<Number>& m) {
    const Number of_first = m.first.x * m.first.x + m.first.y * m.first.y;
    const Number of_second = m.second.x * m.second.x + m.second.y * m.second.y;
    const Matrix2<Number> sorted = choose(of_first < of_second, Matrix2<Number>{m.second, m.first}, m);
    const Number of_longer = of_first < of_second ? of_second : of_first;
    const Number of_shorter = of_first < of_second ? of_first : of_second;
    const Number product = m.first.x * m.second.x + m.first.y * m.second.y;
    const Vector2<Number> by = rotation_of_columns(of_longer, of_shorter, product);
    return {{by.x * sorted.first.x + by.y * sorted.second.x, by.x * sorted.first.y + by.y * sorted.second.y},
            {by.x * sorted.second.x - by.y * sorted.first.x, by.x * sorted.second.y - by.y * sorted.first.y}};
}

}  // namespace nicol
