// SPDX-License-Identifier: MIT
// Distant light for the nodes of lobes.
#pragma once

#include <glm/mat3x3.hpp>
#include <memory>
#include <utility>

#include "light/light_pyramid.hpp"
#include "material/sampled_terms.hpp"
#include "shading/node_grids.hpp"

namespace nicol {

/// An environment that the sampled terms of materials reflect. Immutable; threads share it.
class SampledEnvironment {
public:
    using Light = std::shared_ptr<const LightPyramid>;
    /// Takes `whole`, the light for terms that find lights, and `rest`, the light for others, without
    /// extracted lights; null if there are no such terms. to_points: a rotation from the environment's axes
    /// to the points'. scale: a factor of the light. grids: for the nodes of lobes.
    SampledEnvironment(Light whole, Light rest, const glm::mat3& to_points, float scale, SampledTerms sampled,
                       std::shared_ptr<const NodeGrids> grids)
        : whole_(std::move(whole)),
          rest_(std::move(rest)),
          to_points_(to_points),
          scale_(scale),
          sampled_(sampled),
          grids_(std::move(grids)) {}

    [[nodiscard]] SampledTerms sampled() const noexcept { return sampled_; }
    /// Returns grids for the nodes of lobes.
    [[nodiscard]] const NodeGrids& grids() const noexcept { return *grids_; }

    /// whole: whether extracted lights are included. Computes the mean radiance in blobs of these variances,
    /// see LightPyramid, around the directions out.towards, which are unit vectors in the points' axes: all
    /// other members of `out`, with radiance in place of irradiance.
    void look_up(bool whole, const Lanes& variances, LaneLight& out) const;

private:
    Light whole_, rest_;
    glm::mat3 to_points_;
    float scale_;
    SampledTerms sampled_;
    std::shared_ptr<const NodeGrids> grids_;
};

}  // namespace nicol
