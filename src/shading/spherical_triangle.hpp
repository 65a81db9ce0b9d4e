// SPDX-License-Identifier: MIT
// Triangles as seen from a point.
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace nicol {

/// Triangle on the unit sphere, the projection of a triangle in space.
class SphericalTriangle {
public:
    /// Takes the corners relative to the point.
    explicit SphericalTriangle(const std::array<glm::dvec3, 3>& corners);

    /// Returns the solid angle in steradians; 0 if the triangle is seen edge on, or has a corner at the
    /// point.
    [[nodiscard]] double solid_angle() const noexcept { return solid_angle_; }

    /// Returns the direction that u and v in [0, 1] choose, uniform over the solid angle (Arvo 1995).
    /// solid_angle() must be above 0.
    [[nodiscard]] glm::dvec3 sample(double u, double v) const;

private:
    std::array<glm::dvec3, 3> corners_;  // unit vectors
    double angle_ = 0;                   // at the first corner
    double solid_angle_ = 0;
};

}  // namespace nicol
