// SPDX-License-Identifier: MIT
// Distant light averaged over solid angles, for lobes of materials.
#pragma once

#include <cmath>
#include <cstddef>

#include "light/environment.hpp"
#include "light/equirect_texels.hpp"
#include "light/image_levels.hpp"
#include "light/lane_light.hpp"

namespace nicol {

/// An environment's image, and images of its light averaged over round blobs, each of twice the variance of
/// the one before. Immutable; threads share it.
class LightPyramid {
public:
    /// Components of the environment's light that are kept.
    enum class Kept { stokes, radiance };

    /// most_columns: of an image that is blurred; wider ones are averaged first. kept: radiance alone makes
    /// the light unpolarized.
    explicit LightPyramid(const Environment& environment, int most_columns = 1024, Kept kept = Kept::stokes);

    /// Computes the mean radiance in blobs around the directions `out.towards`, of any length and in the
    /// environment's axes: out.irradiance, out.components and, of polarized light, out.x. variances: of the
    /// blobs, along each axis, in square radians. Blobs are close to normal distributions.
    void look_up(const Lanes& variances, LaneLight& out) const;
    /// Computes this and `leans`: from the middles of blobs, on the unit sphere, to the mean directions of
    /// their light. The light must not be polarized.
    void look_up(const Lanes& variances, LaneLight& out, LaneVectors& leans) const;

    /// Returns the standard deviation, in radians, of the narrowest blobs.
    [[nodiscard]] float narrowest() const { return std::sqrt(first_variance_); }
    [[nodiscard]] bool polarized() const noexcept { return components_ > 1; }
    [[nodiscard]] std::size_t bytes() const noexcept { return levels_.bytes(); }

private:
    [[nodiscard]] EquirectTexels half_of(const EquirectTexels& image) const;
    [[nodiscard]] EquirectTexels blurred(const EquirectTexels& image, int width, double variance) const;

    [[nodiscard]] ImageLevels::Places places_of(const Lanes& variances, const LaneVectors& towards) const;
    void put_unpolarized(const Lanes* found, LaneLight& out) const;

    std::size_t channels_;
    std::size_t components_;
    std::size_t planes_;    // one per channel if the light is polarized, else one per four channels
    float first_variance_;  // of level 1
    ImageLevels levels_;    // level 0 is the image itself
};

}  // namespace nicol
