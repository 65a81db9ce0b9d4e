// SPDX-License-Identifier: MIT
#include "shading/spherical_triangle.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace nicol {
namespace {

// Returns the unit vector orthogonal to `axis` in the direction of v.
glm::dvec3 across(const glm::dvec3& v, const glm::dvec3& axis) {
    return glm::normalize(v - glm::dot(v, axis) * axis);
}

}  // namespace

SphericalTriangle::SphericalTriangle(const std::array<glm::dvec3, 3>& corners) : corners_(corners) {
    for (glm::dvec3& corner : corners_) {
        const double length = glm::length(corner);
        if (!(length > 0)) return;
        corner /= length;
    }
    const auto& [a, b, c] = corners_;
    // The solid angle by Van Oosterom and Strackee (1983), and the angle at a by the planes of its edges.
    const double volume = std::abs(glm::dot(a, glm::cross(b, c)));
    const double angle = 2 * std::atan2(volume, 1 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a));
    const glm::dvec3 ab = glm::cross(a, b), ac = glm::cross(a, c);
    angle_ = std::atan2(glm::length(glm::cross(ab, ac)), glm::dot(ab, ac));
    constexpr double least = 1e-9;  // below which the angles have no digits left
    if (volume > least && std::sin(angle_) > least) solid_angle_ = angle;
}

glm::dvec3 SphericalTriangle::sample(double u, double v) const {
    const auto& [a, b, c] = corners_;
    // The triangle a, b, d with d on the arc from a to c has the fraction u of the solid angle.
    const double part = u * solid_angle_;
    const double cosine = std::cos(angle_), sine = std::sin(angle_);
    const double s = std::sin(part - angle_), t = std::cos(part - angle_);
    const double x = t - cosine;
    const double y = s + sine * glm::dot(a, b);
    const double divisor = (y * s + x * t) * sine;
    const double q = divisor != 0 ? std::clamp(((y * t - x * s) * cosine - y) / divisor, -1.0, 1.0) : 1.0;
    const glm::dvec3 d = glm::normalize(q * a + std::sqrt(1 - q * q) * across(c, a));
    // The direction lies on the arc from b to d.
    const double height = 1 - v * (1 - std::clamp(glm::dot(d, b), -1.0, 1.0));
    const glm::dvec3 aside = d - glm::dot(d, b) * b;
    if (!(glm::dot(aside, aside) > 0)) return b;
    return glm::normalize(height * b + std::sqrt(std::max(0.0, 1 - height * height)) * glm::normalize(aside));
}

}  // namespace nicol
