// SPDX-License-Identifier: MIT
// The directions in which sixteen vertices take light of high orders.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "polarization/lane_points.hpp"
#include "polarization/viewpoint.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// The directions d, x, y and -n of HighOrderFactors in the axes of the light, and the view. A normal that
/// faces away is treated as viewed at 90 degrees, from anywhere if it does so exactly; viewed head-on, every
/// plane is one of incidence.
struct LaneMirror {
    LaneVectors d;       ///< the mirrored view direction
    LaneVectors x;       ///< of the s-frame, orthogonal to the plane of incidence
    LaneVectors y;       ///< d x x
    LaneVectors inward;  ///< -n
    LaneVectors local;   ///< d once more, in the frame of the vertex (theta_phi_frame of the normal)
    Lanes cosine;        ///< of the zenith angle of the viewer, below 0 where the normal faces away
    /// Take (s1, s2) from the s-frame to the camera's frame field: cos s1 + sin s2 and cos s2 - sin s1.
    Lanes frame_cosine;
    Lanes frame_sine;
};

/// At most kLanes positions and their unit normals; the other lanes repeat the first.
[[nodiscard]] LaneMirror mirror_views(const Viewpoint& view, const glm::dmat3& world_to_light,
                                      std::span<const glm::vec3> positions,
                                      std::span<const glm::vec3> normals);

}  // namespace nicol
