// SPDX-License-Identifier: MIT
// What a pixel that shows a surface sees in it as in a mirror.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/projection.hpp"
#include "shading/reflected_nodes.hpp"

namespace nicol {

/// Triangle that a pixel shows, in the axes of the projection.
struct ShownTriangle {
    std::array<glm::vec3, 3> corners;
    std::array<glm::vec3, 3> normals;  ///< of the corners
    glm::vec3 facet;                   ///< unit geometric normal, either sign
};

/// Returns the change of a triangle's interpolated normal along a way in its plane, orthogonal to the unit
/// normal.
[[nodiscard]] glm::dvec3 bend_of_normal(const ShownTriangle& triangle, const glm::dvec3& way,
                                        const glm::dvec3& normal);

/// Returns what a sample of an image of width x height pixels shows mirrored. position: that of the shown
/// point, on the triangle. normal: the unit shading normal there. middle: the sample's place on the image
/// plane, see on_image_plane(), which may be beside the point. Each change of direction is at most 1 long.
[[nodiscard]] MirroredPixel mirrored_pixel(const Projection& projection, int width, int height,
                                           const ShownTriangle& triangle, const glm::vec3& position,
                                           const glm::vec3& normal, const glm::dvec2& middle);

}  // namespace nicol
