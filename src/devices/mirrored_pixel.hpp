// SPDX-License-Identifier: MIT
// What a pixel that shows a surface sees in it as in a mirror.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "scene/projection.hpp"

namespace nicol {

/// Triangle that a pixel shows, in the axes of the projection.
struct ShownTriangle {
    std::array<glm::vec3, 3> corners;
    std::array<glm::vec3, 3> normals;  ///< of the corners
    glm::vec3 facet;                   ///< unit geometric normal, either sign
};

/// Returns the changes of the mirrored view direction from one sample of an image of width x height pixels
/// to the next to the right and to the next below. position: that of the sample, on the triangle. normal: the
/// unit shading normal there. Each change is at most 1 long.
[[nodiscard]] std::array<glm::vec3, 2> mirrored_steps(const Projection& projection, int width, int height,
                                                      const ShownTriangle& triangle,
                                                      const glm::vec3& position, const glm::vec3& normal);

}  // namespace nicol
