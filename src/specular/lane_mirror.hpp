// SPDX-License-Identifier: MIT
// Directions in which sixteen vertices evaluate light of high orders.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "polarization/lane_points.hpp"
#include "polarization/views.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// The directions d, x, y and -n of HighOrderFactors in the axes of the light, and the view. A normal that
/// faces away is treated as viewed at 90 degrees. The plane of incidence is arbitrary if the view is along
/// the normal, from either side.
struct LaneMirror {
    LaneVectors d;       ///< mirrored view direction
    LaneVectors x;       ///< x axis of the s-frame, orthogonal to the plane of incidence
    LaneVectors y;       ///< d x x, the y axis of the s-frame
    LaneVectors inward;  ///< -n, the inward normal
    LaneVectors local;   ///< d in the frame of the vertex (theta_phi_frame of the normal)
    Lanes cosine;        ///< cosine of the viewer's zenith angle, below 0 if the normal faces away
    /// Rotation of (s1, s2) from the s-frame to the camera's frame field: cos s1 + sin s2 and cos s2 - sin
    /// s1.
    Lanes frame_cosine;
    Lanes frame_sine;
};

/// Returns the mirrored views of at most kLanes positions with unit normals; the other lanes repeat the
/// first.
[[nodiscard]] LaneMirror mirror_views(const Views& views, const glm::dmat3& world_to_light,
                                      std::span<const glm::vec3> positions,
                                      std::span<const glm::vec3> normals);

}  // namespace nicol
