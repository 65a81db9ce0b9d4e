// SPDX-License-Identifier: MIT
// Surroundings that the surface in a pixel shows as a mirror.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>

#include "polarization/lane_points.hpp"
#include "scene/projection.hpp"
#include "shading/reflected_nodes.hpp"
#include "surfaces/lane_triangles.hpp"

namespace nicol {

/// Triangle with normals at its corners.
struct ShownTriangle {
    std::array<glm::vec3, 3> corners;
    std::array<glm::vec3, 3> normals;  ///< of the corners
};

/// Returns the change of a triangle's interpolated normal along a way in its plane, orthogonal to the unit
/// normal.
[[nodiscard]] glm::dvec3 bend_of_normal(const ShownTriangle& triangle, const glm::dvec3& way,
                                        const glm::dvec3& normal);

/// Samples of an image, sixteen side by side.
struct LaneSamples {
    Lanes right, up;      ///< places on the image plane, see on_image_plane()
    Lanes width, height;  ///< sides of the samples, relative to an even sample's
};

/// Points that samples show, sixteen side by side.
struct ShownPoints {
    const LaneTriangles& triangles;
    const LaneVectors& facets;             ///< unit geometric normals, either sign
    std::span<const glm::vec3> positions;  ///< on the triangles; at most kLanes
    const LaneVectors& normals;            ///< unit shading normals
};

/// Computes what samples of an image of width x height pixels show mirrored. A sample may be beside its
/// point. Each change of direction across an even sample is at most 1 long.
void mirrored_pixels(const Projection& projection, int width, int height, const ShownPoints& points,
                     const LaneSamples& samples, MirroredPixels& out);

}  // namespace nicol
