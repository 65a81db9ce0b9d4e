// SPDX-License-Identifier: MIT
// Directions towards the light, where it is bright more often.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "light/environment.hpp"

namespace nicol {

struct LightSample {
    glm::dvec3 towards_light;  ///< unit, in the light's own axes
    double pdf;                ///< per steradian, above 0
};

/// Samples directions in proportion to |s0|, mean over the channels, of an environment's image. Between the
/// image's rows and columns the density is bilinear in azimuth and height (the cosine of the zenith angle),
/// so that each cell's share is exact, and zero only where the bilinear look-up of the light is.
class LightSampler {
public:
    explicit LightSampler(const Environment& environment);

    /// The image is black: there is nothing to sample and the density is 0 everywhere.
    [[nodiscard]] bool dark() const noexcept { return !(total_ > 0); }
    /// `point` in [0, 1)^2; not for dark light.
    [[nodiscard]] LightSample sample(const glm::dvec2& point) const;
    /// The density of a unit direction, per steradian.
    [[nodiscard]] double pdf(const glm::dvec3& towards_light) const;

private:
    /// Values at the corners of a cell: upper left, upper right, lower left, lower right.
    struct Corners {
        double ul, ur, ll, lr;
    };
    [[nodiscard]] Corners corners(int row, int column) const;
    /// sin^2 of half the zenith angle of an image row: linear in solid angle, exact near the zenith.
    [[nodiscard]] double depth(int row) const;

    int width_, height_;
    std::vector<float> values_;  ///< [row][column]
    std::vector<double> cells_;  ///< [row][column], cumulative within the row
    std::vector<double> rows_;   ///< cumulative
    double total_ = 0;           ///< integral over the sphere
};

}  // namespace nicol
