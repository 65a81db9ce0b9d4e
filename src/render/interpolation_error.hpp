// SPDX-License-Identifier: MIT
// What is lost where Stokes vectors are interpolated across triangles.
#pragma once

#include "polarization/viewpoint.hpp"
#include "render/geometry.hpp"

namespace nicol {

/// Predicts the error of shading at vertices instead of pixels, relative to the RMS of s0, in a view of
/// surfaces in light up to an order. From corner to corner of a triangle the mirrored view direction turns by
/// an angle a, by its normals and by its size; what a lobe of angular radius w reflects has orders up to l =
/// min(1 / w, order), of which linear interpolation misses about l (l + 1) a^2 / sqrt(120). The mean is over
/// triangles that face the viewer, by the solid angles under which they are seen; of many, some thousands are
/// looked at.
[[nodiscard]] double interpolation_error(const WorldGeometry& geometry, const Viewpoint& view, int order);

}  // namespace nicol
