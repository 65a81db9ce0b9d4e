// SPDX-License-Identifier: MIT
// Points to be shaded, on the device: vertices, or points that pixels show.
#pragma once

#include "draw/stokes_buffer.hpp"
#include "draw/vertex_buffers.hpp"

namespace nicol {

struct DevicePoints {
    const gl::Buffer* positions;  ///< three floats per point
    const gl::Buffer* normals;    ///< three floats per point
    /// Visible fractions of the lobes of high orders, two floats per point; null: lobes are not shadowed.
    const gl::Buffer* fractions;
    const StokesBuffer* stokes;  ///< written by shading
};

/// Returns a scene's vertices. fractions: whether to take the fractions of the buffers.
[[nodiscard]] inline DevicePoints vertex_points(VertexBuffers& buffers, const WorldGeometry& geometry,
                                                bool fractions) {
    return {.positions = buffers.positions().get(),
            .normals = buffers.normals(geometry).get(),
            .fractions = fractions ? buffers.fractions().get() : nullptr,
            .stokes = &buffers.stokes()};
}

}  // namespace nicol
