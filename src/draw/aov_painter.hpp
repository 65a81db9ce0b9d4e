// SPDX-License-Identifier: MIT
// Drawing of AOVs beside a Stokes image: depth, normals, positions, instances and coverage.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "draw/alpha_masks.hpp"
#include "draw/framebuffer.hpp"
#include "draw/vertex_buffers.hpp"
#include "gl/draw.hpp"
#include "scene/projection.hpp"

namespace nicol {

/// Painter of AOVs, which holds memory on the device only while AOVs are requested. All members must be
/// called inside run() of the context.
class AovPainter {
public:
    explicit AovPainter(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Allocates everything that draw() needs; the framebuffer keeps its content. mask: bits of AovBit.
    /// samples: offsets of a pixel's samples, as in sample_pattern().
    void prepare(const WorldGeometry& geometry, VertexBuffers& buffers, const AlphaMasks& alpha_masks,
                 std::uint32_t mask, std::span<const glm::dvec2> samples, Framebuffer& target);
    /// Draws the prepared AOVs. `projection` is of the world, to which the rigid motion `to_world` takes the
    /// geometry.
    void draw(const AlphaMasks& alpha_masks, const Projection& projection, const glm::dmat4& to_world,
              Framebuffer& target);

private:
    // Consecutive triangles of one side of one instance.
    struct Batch {
        TriangleBatch triangles;
        std::uint32_t instance;
    };

    void bind(const WorldGeometry& geometry, VertexBuffers& buffers);
    void prepare_sample();
    // textures: number of textures of an opacity.
    gl::Program& program(const char* vertex, const char* fragment, int textures = 0);
    void clear(gl::RenderTarget& image) const;
    void draw_surfaces(const AlphaMasks& alpha_masks, const Projection& projection, std::size_t sample,
                       const glm::dmat4& to_world, gl::RenderTarget& image);
    // Adds the content of sample_ to the attachments.
    void merge(std::size_t sample);

    std::shared_ptr<gl::Context> context_;
    // Programs by fragment shader, mask, number of textures of an opacity.
    std::map<std::tuple<std::string, std::uint32_t, int>, gl::Program> programs_;
    std::optional<gl::VertexArray> vertices_;
    std::vector<Batch> batches_;
    Stage<Version> binding_;  // buffers
    std::uint32_t mask_ = 0;
    std::uint32_t drawn_ = 0;  // mask_, and the depth if it decides which sample is nearest
    std::span<const glm::dvec2> samples_;
    std::optional<gl::RenderTarget> sample_;  // one sample of every pixel; none: pixels have one sample
    std::shared_ptr<gl::RenderTarget> attachments_;
};

}  // namespace nicol
