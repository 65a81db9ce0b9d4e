// SPDX-License-Identifier: MIT
// draw: depth, normals, positions and instances beside a Stokes image.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gl/draw.hpp"
#include "render/framebuffer.hpp"
#include "render/vertex_buffers.hpp"
#include "scene/projection.hpp"

namespace nicol {

/// Holds memory on the device only while AOVs are requested. All
/// members inside run() of the context.
class AovPainter {
public:
    explicit AovPainter(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Allocates all that draw() needs; the framebuffer keeps its content. `mask`: bits of AovBit.
    void prepare(const WorldGeometry& geometry, VertexBuffers& buffers, std::uint32_t mask,
                 Framebuffer& target);
    /// Draws what was prepared: of the nearest of a pixel's samples. `projection` is of the world, to which
    /// the rigid motion `to_world` takes the geometry.
    void draw(const Projection& projection, const glm::dmat4& to_world, std::span<const glm::dvec2> samples,
              Framebuffer& target);

private:
    // Consecutive triangles of one side of one instance.
    struct Batch {
        std::uint32_t instance;
        bool two_sided;
        std::size_t first;  // index
        std::size_t last;
    };

    void bind(const WorldGeometry& geometry, VertexBuffers& buffers);

    std::shared_ptr<gl::Context> context_;
    std::map<std::uint32_t, gl::Program> programs_;  // by mask
    std::optional<gl::VertexArray> vertices_;
    std::vector<Batch> batches_;
    Stage<Version> binding_;  // buffers
    std::uint32_t mask_ = 0;
    std::shared_ptr<gl::RenderTarget> attachments_;
};

}  // namespace nicol
