// SPDX-License-Identifier: MIT
// Change of texture coordinates from a pixel to its neighbours.
#pragma once

#include <glm/vec3.hpp>

#include "shading/normal_variation.hpp"
#include "texture/texture.hpp"

namespace nicol {

/// Steps between the rays of an image's pixels.
struct PixelSteps {
    glm::vec3 forward;  ///< view direction, unit
    glm::vec3 right,
        down;  ///< steps to the next pixels at unit distance along `forward`; orthographic: in the world
    bool orthographic;
};

/// Sets du and dv of points of triangles with these axes: the change of texture coordinates to the points
/// where the neighbours' rays meet the triangle's plane, to first order. towards_viewer: minus the ray to the
/// point; for a perspective camera, the ray starts at the eye. Cosines below 1e-4 (edge-on views) are
/// clamped. du and dv are 0 without axes.
void find_footprints(const PixelSteps& steps, const LaneTextureAxes& axes, const LaneVectors& towards_viewer,
                     TexturePoints& points);

}  // namespace nicol
