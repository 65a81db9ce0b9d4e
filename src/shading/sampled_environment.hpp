// SPDX-License-Identifier: MIT
// Distant light for the nodes of lobes.
#pragma once

#include <glm/mat3x3.hpp>
#include <memory>
#include <utility>

#include "light/light_pyramid.hpp"
#include "material/sampled_terms.hpp"
#include "shading/lane_frames.hpp"
#include "shading/node_grids.hpp"
#include "shading/reflected_nodes.hpp"

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
    /// Returns whether the light may be polarized.
    [[nodiscard]] bool polarized() const noexcept {
        return (whole_ && whole_->polarized()) || (rest_ && rest_->polarized());
    }
    /// Returns the standard deviation, in radians, of the narrowest blobs of `whole`.
    [[nodiscard]] float narrowest() const { return whole_->narrowest(); }
    /// Returns grids for the nodes of lobes.
    [[nodiscard]] const NodeGrids& grids() const noexcept { return *grids_; }

    /// Returns frames in the points' axes as frames in the environment's axes.
    [[nodiscard]] LaneFrames in_environment(const LaneFrames& of_points) const;
    /// whole: whether extracted lights are included. Computes the radiance that a node sees, times the node's
    /// weights: all members of `out`, with directions in the surfaces' frames. frames: in_environment().
    void look_up(bool whole, const LaneFrames& frames, const ReflectedNode& node, LaneLight& out) const;
    /// Computes this and `lean`, from the middle of the node's blob to the mean direction of its light, in
    /// the surfaces' frames. The light must not be polarized.
    void look_up(bool whole, const LaneFrames& frames, const ReflectedNode& node, LaneLight& out,
                 LaneVectors& lean) const;

private:
    void set_node(const ReflectedNode& node, LaneLight& out) const;

    Light whole_, rest_;
    glm::mat3 to_points_;
    float scale_;
    SampledTerms sampled_;
    std::shared_ptr<const NodeGrids> grids_;
};

}  // namespace nicol
