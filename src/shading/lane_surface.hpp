// SPDX-License-Identifier: MIT
// Points of triangles that sixteen pixels show.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "polarization/lane_points.hpp"
#include "polarization/viewpoint.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// Interpolated values at sixteen points of triangles.
struct LaneSurface {
    std::array<Lanes, 3> weights;  ///< barycentric weights of the corners, 0 to 1; their sum is 1
    std::array<glm::vec3, kLanes> positions;
    std::array<glm::vec3, kLanes> normals;  ///< unit normals
    /// Unit normals without a texture's perturbation; set only if a texture perturbs normals.
    std::array<glm::vec3, kLanes> unperturbed;
    /// Number of parts along each side of a sample, in `parts`.
    static constexpr std::size_t kPartsAcross = 4;
    /// Unit normals at the middles of the sample's parts, perturbed by the means of the texture over each,
    /// row by row; set only where TexturedPixels::find() is asked for them.
    std::array<LaneVectors, kPartsAcross * kPartsAcross> parts;
    /// X axes of anisotropic materials, unit or 0; set only if a texture or an angle rotates them.
    std::array<glm::vec3, kLanes> tangents;
};

/// Corners of a triangle: indices of vertices.
using Corners = glm::uvec3;

/// Finds the points where the rays through `at` meet the planes of triangles; a point outside its triangle is
/// moved inside. `at`: points on the image plane, in units of right and up, at unit distance (perspective) or
/// in world units (orthographic). If the normals of the corners cancel, the normal points to the camera. At
/// most kLanes triangles, and as many points.
void find_surface(const Viewpoint& view, std::span<const glm::vec3> positions,
                  std::span<const glm::vec3> normals, std::span<const Corners> triangles,
                  std::span<const glm::vec2> at, LaneSurface& out);

}  // namespace nicol
