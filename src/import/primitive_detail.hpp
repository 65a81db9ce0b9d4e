// SPDX-License-Identifier: MIT
// Detail of the triangulation of spheres, discs and cylinders, by their size in the picture.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "import/scene_description.hpp"
#include "scene/camera.hpp"

namespace nicol {

class PrimitiveDetail {
public:
    /// size: size of the picture in pixels.
    PrimitiveDetail(const Camera& camera, glm::ivec2 size);

    /// Returns the least detail, see make_sphere(), of a few steps, for which the outline of a shape lies at
    /// most a twentieth of a pixel inside the true one. 1, full detail, for shapes that emit light, because
    /// flat triangles emit less, for shapes around the camera, and for other kinds of shapes.
    [[nodiscard]] double of(const ShapeDescription& shape) const;

private:
    glm::dvec3 eye_;
    bool orthographic_;
    double scale_;  // pixels of a unit length, at distance 1 if the camera is perspective
};

}  // namespace nicol
