// SPDX-License-Identifier: MIT
// A scene's vertices on the device, which shading writes and drawing reads.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "draw/corner_buffers.hpp"
#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "methods/transfer_input.hpp"
#include "polarization/viewpoint.hpp"

namespace nicol {

/// Buffers of a scene's vertices. All members must be called inside run() of the context.
class VertexBuffers {
public:
    explicit VertexBuffers(std::shared_ptr<gl::Context> context)
        : context_(std::move(context)), corners_(context_) {}

    /// Makes the buffers for a geometry and a number of channels; repeats only what changes require.
    void update(const WorldGeometry& geometry, Version geometry_version, int channels);
    /// Uploads Stokes vectors that were computed on the host.
    void upload(const VertexStokes& stokes);

    /// Returns whether there is nothing to draw. If so, the buffers below do not exist.
    [[nodiscard]] bool empty() const noexcept { return indices_ == nullptr; }
    /// Returns a version that changes each time the buffers are made anew.
    [[nodiscard]] Version version() const noexcept { return version_; }

    [[nodiscard]] const std::shared_ptr<const gl::IndexBuffer>& indices() const noexcept { return indices_; }
    /// Returns the positions, three floats per vertex.
    [[nodiscard]] const std::shared_ptr<const gl::Buffer>& positions() const noexcept { return positions_; }
    /// Returns the normals, three floats per vertex. Uploaded on first use.
    [[nodiscard]] const std::shared_ptr<const gl::Buffer>& normals(const WorldGeometry& geometry);
    /// Returns the Stokes vectors of a channel, one vec4 per vertex.
    [[nodiscard]] const std::shared_ptr<gl::Buffer>& stokes(int channel) const {
        return stokes_[static_cast<std::size_t>(channel)];
    }
    /// Returns the visible fractions of the lobes of high orders, one vec2 per vertex. Made on first use.
    [[nodiscard]] const std::shared_ptr<gl::Buffer>& fractions();

    /// Returns the buffers of triangles' corners, which their own update() uploads.
    [[nodiscard]] CornerBuffers& corners() noexcept { return corners_; }

private:
    std::shared_ptr<gl::Context> context_;
    CornerBuffers corners_;
    Version version_ = 0;
    Stage<Version> placing_;
    Stage<Version, int> sizing_;
    std::shared_ptr<const gl::IndexBuffer> indices_;
    std::shared_ptr<const gl::Buffer> positions_;
    std::shared_ptr<const gl::Buffer> normals_;
    std::vector<std::shared_ptr<gl::Buffer>> stokes_;
    std::shared_ptr<gl::Buffer> fractions_;
};

/// Sets the uniforms of glsl/vertex_view.glsl that the program uses.
void set_view_uniforms(gl::Program& program, const Viewpoint& view);

}  // namespace nicol
