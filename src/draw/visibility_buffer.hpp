// SPDX-License-Identifier: MIT
// Visibility buffer: the triangle at each sample of a pixel, for shading at pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "draw/alpha_masks.hpp"
#include "draw/sample_pattern.hpp"
#include "draw/vertex_buffers.hpp"
#include "gl/draw.hpp"
#include "gl/program.hpp"
#include "gl/render_target.hpp"
#include "scene/projection.hpp"
#include "versioned.hpp"

namespace nicol {

/// Triangle of a WorldGeometry, and whether the camera sees its front.
struct Hit {
    std::uint32_t triangle;
    bool front;
};

class VisibilityBuffer {
public:
    explicit VisibilityBuffer(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Location of the hits.
    enum class Kept {
        on_host,    ///< host memory, for at()
        on_device,  ///< device memory, for texture()
        on_both,
    };

    /// Draws the hits. `buffers` and `alpha_masks` must belong to `geometry`; `projection` is of the
    /// geometry's axes. offsets: of the samples, as in sample_pattern(). Must be called inside run() of the
    /// context.
    void draw(const WorldGeometry& geometry, VertexBuffers& buffers, const AlphaMasks& alpha_masks,
              const Projection& projection, int width, int height, std::span<const glm::dvec2> offsets,
              Kept kept);

    /// Returns the offsets of the samples of the last draw().
    [[nodiscard]] std::span<const glm::dvec2> offsets() const { return offsets_; }
    /// Returns the hit at a sample; none if no surface is there. pixel: index, row by row.
    [[nodiscard]] std::optional<Hit> at(std::size_t sample, std::size_t pixel) const {
        const std::uint32_t texel = texels_[sample][pixel];
        if (texel == 0) return std::nullopt;
        return Hit{.triangle = (texel & ~kFront) - 1, .front = (texel & kFront) != 0};
    }

    /// Frees all memory.
    void clear();
    /// Returns the number of bytes that are kept outside the context.
    [[nodiscard]] std::uint64_t bytes() const;
    /// Returns the number of bytes per pixel that draw() takes, the context's memory included.
    [[nodiscard]] static std::uint64_t bytes_per_pixel(std::size_t samples, Kept kept) {
        const std::size_t targets = kept == Kept::on_host ? 1 : samples;
        const std::size_t read = kept == Kept::on_device ? 0 : samples;
        return read * sizeof(std::uint32_t) + targets * (sizeof(std::uint32_t) + sizeof(float));
    }

    /// Returns the texture that glsl/hits.glsl reads.
    [[nodiscard]] const gl::Texture2D& texture(std::size_t sample) const {
        return targets_[sample].colour(0);
    }

    [[nodiscard]] int width() const { return targets_.front().width(); }
    [[nodiscard]] int height() const { return targets_.front().height(); }

private:
    static constexpr std::uint32_t kFront = 0x80000000;  // must equal the value in hits.frag

    void find_batches(const WorldGeometry& geometry, const AlphaMasks& alpha_masks);
    gl::Program& program(int textures);
    void draw_sample(const AlphaMasks& alpha_masks, const Projection& projection, std::size_t sample,
                     gl::RenderTarget& target);

    std::shared_ptr<gl::Context> context_;
    std::map<int, gl::Program> programs_;    // by number of textures of an opacity
    std::vector<TriangleBatch> batches_;     // triangles without alpha masks are merged
    std::vector<gl::RenderTarget> targets_;  // one per sample, or one for all samples that are read back
    Stage<int, int, std::size_t> sizing_;    // width, height, targets
    std::optional<gl::VertexArray> vertices_;
    Stage<Version> binding_;
    Stage<Version, Version> batching_;  // buffers, alpha masks
    std::span<const glm::dvec2> offsets_;
    std::array<std::vector<std::uint32_t>, kMostPixelSamples> texels_;  // by sample
};

}  // namespace nicol
