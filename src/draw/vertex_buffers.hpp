// SPDX-License-Identifier: MIT
// A scene's vertices and its triangles' corners on the device. Shading writes the vertices; drawing reads
// both.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "draw/stokes_buffer.hpp"
#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "methods/transfer_input.hpp"
#include "polarization/viewpoint.hpp"
#include "surfaces/geometry.hpp"
#include "versioned.hpp"

namespace nicol {

/// Buffer of triangles' corners. All members must be called inside run() of the context.
class CornerBuffers {
public:
    explicit CornerBuffers(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Copies a geometry's corners; repeats only what changes require. Throws Error(unsupported) for more
    /// triangles than the driver lets a shader reach.
    void update(const WorldGeometry& geometry, Version geometry_version, Version material_version);

    /// Binds the buffer, which has numbers() floats per triangle: u and v of the corners; the shifts of a
    /// point as u and as v grows; the tangents of the corners, if with_tangents(); their colours, if
    /// colored().
    void bind(unsigned binding) const { buffer_->bind_storage(binding); }
    [[nodiscard]] int numbers() const noexcept { return 12 + (with_tangents_ ? 12 : 0) + (colored_ ? 9 : 0); }
    [[nodiscard]] bool with_tangents() const noexcept { return with_tangents_; }
    [[nodiscard]] bool colored() const noexcept { return colored_; }

private:
    std::shared_ptr<gl::Context> context_;
    Stage<Version, Version> copying_;
    bool with_tangents_ = false;
    bool colored_ = false;
    std::optional<gl::Buffer> buffer_;
};

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
    [[nodiscard]] const StokesBuffer& stokes() const { return stokes_.value(); }
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
    std::optional<StokesBuffer> stokes_;
    std::shared_ptr<gl::Buffer> fractions_;
};

/// Sets the uniforms of glsl/vertex_view.glsl that the program uses.
void set_view_uniforms(gl::Program& program, const Viewpoint& view);

}  // namespace nicol
