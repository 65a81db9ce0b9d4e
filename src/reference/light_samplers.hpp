// SPDX-License-Identifier: MIT
// Samplers of the lights that have a size: the environment, discs of the sky, and emissive surfaces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "light/environment.hpp"
#include "light/local_light.hpp"
#include "reference/traced_surface.hpp"

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

/// A directional light with a size, a disc of the sky: even radiance in the directions up to an angle from
/// the middle. All directions are in the world.
class SkyDisc {
public:
    /// Refers to a directional light with an angular radius above 0.
    explicit SkyDisc(const LocalLight& light);

    [[nodiscard]] const LocalLight& light() const noexcept { return *light_; }
    /// A unit direction towards the light, evenly by solid angle; `point` in [0, 1)^2.
    [[nodiscard]] glm::dvec3 sample(const glm::dvec2& point) const;
    /// The density of a unit direction, per steradian: 0 outside.
    [[nodiscard]] double pdf(const glm::dvec3& towards_light) const;
    [[nodiscard]] double radiance(int channel) const;

private:
    const LocalLight* light_;
    glm::dmat3 axes_;        ///< z towards the middle
    double sin_half_;        ///< of half the radius: exact for the smallest
    double per_irradiance_;  ///< radiance of the irradiance 1
};

/// Samples places evenly by area: of every emissive surface while there are few of them, else of one that
/// is chosen in proportion to its power.
class AreaLightSampler {
public:
    /// More area lights than this share one sample.
    static constexpr std::size_t kFew = 16;

    /// Black surfaces are left out.
    explicit AreaLightSampler(std::span<const TracedSurface> surfaces);

    /// Samples to take for each point that is lit.
    [[nodiscard]] std::size_t samples() const noexcept;
    /// A place for the sample with this index, `point` in [0, 1)^2: a hit without its distance.
    [[nodiscard]] RayHit sample(std::size_t index, glm::dvec2 point) const;
    /// The density of all samples together on a surface, by area; 0 where none are taken.
    [[nodiscard]] double density(std::uint32_t surface) const { return densities_[surface]; }

private:
    struct AreaLight {
        std::uint32_t surface;
        std::vector<double> areas;  ///< of triangles, cumulative
        double power;
    };
    std::vector<AreaLight> area_lights_;
    std::vector<double> powers_;     ///< cumulative
    std::vector<double> densities_;  ///< by surface
};

}  // namespace nicol
