// SPDX-License-Identifier: MIT
// Points to be shaded, on the device: vertices, or what pixels show.
#pragma once

#include <vector>

#include "draw/vertex_buffers.hpp"

namespace nicol {

struct DevicePoints {
    const gl::Buffer* positions;  ///< three floats a point
    const gl::Buffer* normals;    ///< likewise
    const gl::Buffer*
        fractions;  ///< two floats, of the lobes of high orders that are visible; null: all of them
    std::vector<const gl::Buffer*> stokes;  ///< by channel: a vec4, which shading writes
};

/// A scene's vertices; `fractions`: of the buffers.
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
