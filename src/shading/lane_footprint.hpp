// SPDX-License-Identifier: MIT
// How far texture coordinates change from a pixel to its neighbours.
#pragma once

#include <glm/vec3.hpp>

#include "shading/normal_variation.hpp"
#include "texture/texture.hpp"

namespace nicol {

/// The rays of an image's pixels.
struct PixelSteps {
    glm::vec3 forward;  ///< the view direction, unit
    glm::vec3 right,
        down;  ///< to the next pixels at unit distance along `forward`; orthographic: in the world
    bool orthographic;
};

/// Sets du and dv of points of triangles with these axes: to where the neighbours' rays meet the triangle's
/// plane, to first order. towards_viewer: minus the ray to the point, of a perspective camera from its eye
/// on. Edge on, cosines below 1e-4 count as that; without axes du and dv are 0.
void find_footprints(const PixelSteps& steps, const LaneTextureAxes& axes, const LaneVectors& towards_viewer,
                     TexturePoints& points);

}  // namespace nicol
