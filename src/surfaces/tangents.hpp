// SPDX-License-Identifier: MIT
// Tangents: the directions that anisotropic materials follow.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "polarization/stokes.hpp"
#include "shading/normal_variation.hpp"
#include "surfaces/geometry.hpp"

namespace nicol {

/// Returns the texture axes of a triangle, 0 if the geometry has no texture coordinates.
[[nodiscard]] TextureAxes texture_axes(const WorldGeometry& geometry, std::uint32_t triangle);

/// Returns the axes that normal maps and anisotropic materials follow at a point of a triangle: those of the
/// mesh's tangents, else `axes`, the triangle's texture axes. weights: barycentric weights of the point.
/// normal: unit normal of the front.
[[nodiscard]] TextureAxes material_axes(const WorldGeometry& geometry, std::uint32_t triangle,
                                        const glm::vec3& weights, const glm::vec3& normal,
                                        const TextureAxes& axes);

/// Returns the x axis of material_axes(), perpendicular to the interpolated normal: unit, or 0 if there is
/// none.
[[nodiscard]] glm::vec3 tangent(const WorldGeometry& geometry, std::uint32_t triangle,
                                const glm::vec3& weights);

/// Returns the surface's frame whose z is the unit normal and whose x is as nearly along a tangent as
/// possible; any x if the tangent is 0.
[[nodiscard]] Frame frame_along(const glm::dvec3& normal, const glm::dvec3& tangent);

/// Returns, for each vertex, the mean x axis over its triangles, unit or 0. Empty if no material is
/// anisotropic.
[[nodiscard]] std::vector<glm::vec3> vertex_tangents(const WorldGeometry& geometry);

}  // namespace nicol
