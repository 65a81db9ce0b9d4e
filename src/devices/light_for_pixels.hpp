// SPDX-License-Identifier: MIT
// Light of vertices as pixels take it, on threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

#include "methods/bounces.hpp"
#include "transfer/frame_rotation.hpp"
#include "transfer/vertex_light.hpp"

namespace nicol {

/// Rotates light of blocks first <= b < last from the vertices' frames into the geometry's axes, adds bounced
/// light (null: none), and stores the sum as rows. rotation: of the light's layout.
inline void leave_for_pixels(const FrameRotation& rotation, const Bounces* bounces,
                             std::span<const glm::vec3> normals, std::size_t first, std::size_t last,
                             VertexLight& light) {
    for (std::size_t block = first; block < last; ++block) {
        const std::size_t v = block * kLanes;
        rotation.into_world(normals.subspan(v, std::min(kLanes, normals.size() - v)), light, block);
        if (bounces != nullptr) bounces->add_to(light, block, block + 1);
        light.to_rows(block);
    }
}

}  // namespace nicol
