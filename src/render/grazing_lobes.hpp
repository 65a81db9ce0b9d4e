// SPDX-License-Identifier: MIT
// Lobes that an image shows at grazing angles.
#pragma once

#include "render/seen_triangles.hpp"
#include "scene/projection.hpp"
#include "surfaces/geometry.hpp"

namespace nicol {

/// Returns the width below which an image's round lobes are sampled: kNarrowestLobe, or more if the image
/// shows a wider lobe at grazing angles in a good part. A lobe is narrow across the plane of incidence by the
/// cosine of the angle, so that a large floor mirrors the horizon in streaks that orders do not hold.
[[nodiscard]] double narrowest_in_harmonics(const WorldGeometry& geometry, const SeenTriangles& seen,
                                            const Projection& projection);

}  // namespace nicol
