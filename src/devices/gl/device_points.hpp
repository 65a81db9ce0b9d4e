// SPDX-License-Identifier: MIT
// Points to be shaded, on the device: vertices, or points that pixels show.
#pragma once

#include <vector>

#include "draw/vertex_buffers.hpp"

namespace nicol {

struct DevicePoints {
    const gl::Buffer* positions;  ///< three floats per point
    const gl::Buffer* normals;    ///< three floats per point
    /// Visible fractions of the lobes of high orders, two floats per point; null: lobes are not shadowed.
    const gl::Buffer* fractions;
    std::vector<const gl::Buffer*> stokes;  ///< by channel: one vec4 per point, which shading writes
};

/// Returns a scene's vertices. fractions: whether to take the fractions of the buffers.
[[nodiscard]] inline DevicePoints vertex_points(VertexBuffers& buffers, const WorldGeometry& geometry,
                                                int channels, bool fractions) {
    DevicePoints points{.positions = buffers.positions().get(),
                        .normals = buffers.normals(geometry).get(),
                        .fractions = fractions ? buffers.fractions().get() : nullptr,
                        .stokes = {}};
    for (int c = 0; c < channels; ++c) points.stokes.push_back(buffers.stokes(c).get());
    return points;
}

}  // namespace nicol
