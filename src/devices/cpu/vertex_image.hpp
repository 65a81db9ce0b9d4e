// SPDX-License-Identifier: MIT
// Images of shaded vertices, on threads.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "methods/executor.hpp"

namespace nicol {

/// Image whose surfaces show the interpolated Stokes vectors of vertices. Interpolation is linear in each
/// triangle, in perspective, as a rasteriser does it. Calls for different pixels may run in parallel.
class VertexImage {
public:
    /// Projects the vertices. Keeps references to the arguments. stokes: [channel][vertex].
    VertexImage(const PixelInput& input, const VertexStokes& stokes, RenderRun& run);

    /// Writes to out[c][pixel], for first <= pixel < last, the mean of channel c's Stokes vectors over the
    /// samples. Samples without a surface show the background of the pixel's centre.
    void run(std::size_t first, std::size_t last, std::span<const std::span<glm::vec4>> out) const;

private:
    const PixelInput& input_;
    const VertexStokes& stokes_;
    std::vector<glm::dvec3> projected_;  // x, y and w of the vertices in clip space
};

}  // namespace nicol
