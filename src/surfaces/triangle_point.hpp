// SPDX-License-Identifier: MIT
// Points of a geometry's triangles, where paths of light begin, end and turn.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "surfaces/geometry.hpp"
#include "texture/texture.hpp"

namespace nicol {

struct TrianglePoint {
    glm::dvec3 position;
    glm::dvec3 facet;   ///< unit normal of the triangle, towards its front
    glm::dvec3 normal;  ///< unit shading normal
    double offset;      ///< distance from the surface to the start of rays that leave it
};
/// Returns the point with these barycentric weights of corners 1 and 2. otherwise: the facet of a triangle
/// without area.
[[nodiscard]] TrianglePoint triangle_point(const WorldGeometry& geometry, std::uint32_t triangle, double b1,
                                           double b2, const glm::dvec3& otherwise = {0, 0, 1});

/// Returns a vector along a triangle's normal, as long as its area.
[[nodiscard]] glm::dvec3 area_vector(const WorldGeometry& geometry, std::uint32_t triangle);

/// Returns what textures look up at a point of a triangle, without a footprint. weights: of its corners.
[[nodiscard]] TexturePoint texture_point(const WorldGeometry& geometry, std::uint32_t triangle,
                                         const glm::vec3& weights);

}  // namespace nicol
