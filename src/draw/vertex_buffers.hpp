// SPDX-License-Identifier: MIT
// A scene's vertices on the device: what shading writes and drawing reads.
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

/// All members inside run() of the context.
class VertexBuffers {
public:
    explicit VertexBuffers(std::shared_ptr<gl::Context> context)
        : context_(std::move(context)), corners_(context_) {}

    /// Makes the buffers for this geometry and these channels, as far as changes make it necessary.
    void update(const WorldGeometry& geometry, Version geometry_version, int channels);
    /// Stokes vectors made on the host.
    void upload(const VertexStokes& stokes);

    /// Whether there is nothing to draw; then the buffers below do not exist.
    [[nodiscard]] bool empty() const noexcept { return indices_ == nullptr; }
    /// Changes each time that the buffers are made anew.
    [[nodiscard]] Version version() const noexcept { return version_; }

    [[nodiscard]] const std::shared_ptr<const gl::IndexBuffer>& indices() const noexcept { return indices_; }
    /// Three floats a vertex.
    [[nodiscard]] const std::shared_ptr<const gl::Buffer>& positions() const noexcept { return positions_; }
    /// Likewise; uploaded on first use.
    [[nodiscard]] const std::shared_ptr<const gl::Buffer>& normals(const WorldGeometry& geometry);
    /// A vec4 a vertex.
    [[nodiscard]] const std::shared_ptr<gl::Buffer>& stokes(int channel) const {
        return stokes_[static_cast<std::size_t>(channel)];
    }
    /// A vec2 a vertex: the visible fractions of the lobes of high orders. Made on first use.
    [[nodiscard]] const std::shared_ptr<gl::Buffer>& fractions();

    /// Of triangles; uploaded by their own update().
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

/// Sets those uniforms of glsl/vertex_view.glsl that the program uses.
void set_view_uniforms(gl::Program& program, const Viewpoint& view);

}  // namespace nicol
