// SPDX-License-Identifier: MIT
// Vertices whose visibility an image needs.
#pragma once

#include <cstdint>
#include <vector>

#include "surfaces/geometry.hpp"

namespace nicol {

/// Returns 1 for each vertex whose visibility is needed for direct light in an image, else 0: vertices of
/// triangles that can be seen and reflect light, and a sample of the other vertices of each instance, whose
/// shadows say where triangles are refined. All are 0 if no triangle is seen that reflects light. Returns an
/// empty list if so few vertices can be spared that all are needed. The sample does not depend on the view.
/// Runs on the calling thread's TBB arena.
[[nodiscard]] std::vector<std::uint8_t> needed_vertices(const WorldGeometry& geometry,
                                                        const Projection& projection);

/// Returns whether rays of pixels go on from a surface, so that an image needs vertices which it does not
/// show.
[[nodiscard]] bool shows_others(const WorldGeometry& geometry);

}  // namespace nicol
