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
    glm::dvec3 towards_light;  ///< unit vector in the light's own axes
    double pdf;                ///< density per steradian, above 0
};

/// Sampler of directions in proportion to |s0| of an environment's image, averaged over the channels. Between
/// the image's rows and columns the density is bilinear in azimuth and height (the cosine of the zenith
/// angle), so that each cell's share is exact. The density is zero only where the bilinear look-up of the
/// light is zero.
class LightSampler {
public:
    explicit LightSampler(const Environment& environment);

    /// Returns whether the image is black. If so, there is nothing to sample, and the density is 0
    /// everywhere.
    [[nodiscard]] bool dark() const noexcept { return !(total_ > 0); }
    /// Samples a direction. The light must not be dark. point: in [0, 1)^2.
    [[nodiscard]] LightSample sample(const glm::dvec2& point) const;
    /// Returns the density of a unit direction, per steradian.
    [[nodiscard]] double pdf(const glm::dvec3& towards_light) const;

private:
    /// Values at the corners of a cell: upper left, upper right, lower left, lower right.
    struct Corners {
        double ul, ur, ll, lr;
    };
    [[nodiscard]] Corners corners(int row, int column) const;
    /// Returns sin^2 of half the zenith angle of an image row, which is linear in solid angle and exact near
    /// the zenith.
    [[nodiscard]] double depth(int row) const;

    int width_, height_;
    std::vector<float> values_;  ///< [row][column]
    std::vector<double> cells_;  ///< [row][column], cumulative within the row
    std::vector<double> rows_;   ///< sums of the rows, cumulative
    double total_ = 0;           ///< integral over the sphere
};

/// Directional light with a size, a disc of the sky: constant radiance in the directions up to an angle from
/// the middle. All directions are in the world.
class SkyDisc {
public:
    /// Keeps a reference to `light`, a directional light with an angular radius above 0.
    explicit SkyDisc(const LocalLight& light);

    [[nodiscard]] const LocalLight& light() const noexcept { return *light_; }
    /// Samples a unit direction towards the light, uniformly by solid angle. point: in [0, 1)^2.
    [[nodiscard]] glm::dvec3 sample(const glm::dvec2& point) const;
    /// Returns the density of a unit direction, per steradian; 0 outside the disc.
    [[nodiscard]] double pdf(const glm::dvec3& towards_light) const;
    [[nodiscard]] double radiance(int channel) const;

private:
    const LocalLight* light_;
    glm::dmat3 axes_;        ///< z points towards the middle
    double sin_half_;        ///< sine of half the angular radius, exact for the smallest radii
    double per_irradiance_;  ///< radiance per irradiance
};

/// Sampler of places on emissive surfaces, uniform by area. Few surfaces are all sampled; of more surfaces,
/// one is chosen in proportion to its power.
class AreaLightSampler {
public:
    /// Largest number of area lights that have samples of their own. More area lights share one sample.
    static constexpr std::size_t kFew = 16;

    /// Leaves out black surfaces.
    explicit AreaLightSampler(std::span<const TracedSurface> surfaces);

    /// Returns the number of samples for each lit point.
    [[nodiscard]] std::size_t samples() const noexcept;
    /// Samples a place for the sample with this index: a hit without its distance. point: in [0, 1)^2.
    [[nodiscard]] RayHit sample(std::size_t index, glm::dvec2 point) const;
    /// Returns the density by area of all samples together on a surface; 0 if the surface has no samples.
    [[nodiscard]] double density(std::uint32_t surface) const { return densities_[surface]; }

private:
    struct AreaLight {
        std::uint32_t surface;
        std::vector<double> areas;  ///< areas of triangles, cumulative
        double power;
    };
    std::vector<AreaLight> area_lights_;
    std::vector<double> powers_;     ///< powers of the area lights, cumulative
    std::vector<double> densities_;  ///< by surface
};

}  // namespace nicol
