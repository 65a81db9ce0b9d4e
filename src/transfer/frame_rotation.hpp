// SPDX-License-Identifier: MIT
// Rotation of lights that differ from place to place, between the world's axes and surface frames.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

#include "harmonics/lane_rotation.hpp"
#include "harmonics/light_layout.hpp"
#include "transfer/light_fields.hpp"
#include "transfer/vertex_light.hpp"

namespace nicol {

/// Rotation of the LightLayout coefficients of sixteen lights at once, between the world's axes and a frame
/// with z along a normal and x and y along theta-hat and phi-hat there (theta_phi_frame). The frame of the
/// normal (0, 0, 1) is the world's axes. Immutable; threads share it.
class FrameRotation {
public:
    explicit FrameRotation(const LightLayout& layout);

    /// Rotates a block of `light` in place. `normals`: at most kLanes unit vectors, one per lane.
    void into_frames(std::span<const glm::vec3> normals, VertexLight& light, std::size_t block) const;
    void into_world(std::span<const glm::vec3> normals, VertexLight& light, std::size_t block) const;

private:
    template <class Rotate>
    void rotate(const LightFields& from, const LightFields& to, std::span<const glm::vec3> normals,
                VertexLight& light, std::size_t block, const Rotate& one_part) const;

    LaneRotation rotation_;
    LightFields in_world_;
    LightFields in_frame_;
};

}  // namespace nicol
