// SPDX-License-Identifier: MIT
// A scene's vertices on the device: what shading writes and drawing reads.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "gl/buffer.hpp"
#include "render/transfer_input.hpp"

namespace nicol {

/// All members inside run() of the context.
class VertexBuffers {
public:
    explicit VertexBuffers(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Makes the buffers for this geometry and these channels, as far as changes make it necessary.
    void update(const WorldGeometry& geometry, std::uint64_t geometry_revision, int channels);
    /// Stokes vectors made on the host.
    void upload(const VertexStokes& stokes);
    /// Fractions made on the host; empty where there are none.
    void upload(std::span<const glm::vec2> fractions);

    /// Whether there is nothing to draw; then the buffers below do not exist.
    [[nodiscard]] bool empty() const noexcept { return indices_ == nullptr; }
    /// Counts the times the buffers were made anew.
    [[nodiscard]] std::uint64_t revision() const noexcept { return revision_; }

    [[nodiscard]] const std::shared_ptr<const gl::IndexBuffer>& indices() const noexcept { return indices_; }
    /// Three floats a vertex.
    [[nodiscard]] const std::shared_ptr<const gl::Buffer>& positions() const noexcept { return positions_; }
    /// Likewise; uploaded when first asked for.
    [[nodiscard]] const std::shared_ptr<const gl::Buffer>& normals(const WorldGeometry& geometry);
    /// A vec4 a vertex.
    [[nodiscard]] const std::shared_ptr<gl::Buffer>& stokes(int channel) const {
        return stokes_[static_cast<std::size_t>(channel)];
    }
    /// A vec2 a vertex: what it sees of what it reflects of high orders. Made when first asked for.
    [[nodiscard]] const std::shared_ptr<gl::Buffer>& fractions();

private:
    std::shared_ptr<gl::Context> context_;
    std::uint64_t revision_ = 0;
    std::uint64_t geometry_revision_ = 0;
    std::shared_ptr<const gl::IndexBuffer> indices_;
    std::shared_ptr<const gl::Buffer> positions_;
    std::shared_ptr<const gl::Buffer> normals_;
    std::vector<std::shared_ptr<gl::Buffer>> stokes_;
    std::shared_ptr<gl::Buffer> fractions_;
};

}  // namespace nicol
