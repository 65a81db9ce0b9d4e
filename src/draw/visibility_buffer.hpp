// SPDX-License-Identifier: MIT
// Visibility buffer: the triangle at each sample of a pixel, for shading at pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "draw/sample_pattern.hpp"
#include "gl/render_target.hpp"
#include "versioned.hpp"

namespace nicol {

/// Triangle of a WorldGeometry, and whether the camera sees its front.
struct Hit {
    std::uint32_t triangle;
    bool front;
};

/// Hits at the samples of an image's pixels. A HitFinder fills it.
class VisibilityBuffer {
public:
    explicit VisibilityBuffer(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Location of the hits.
    enum class Kept {
        on_host,    ///< host memory, for at()
        on_device,  ///< device memory, for texture()
        on_both,
    };

    /// Makes room for hits, whose values are then undefined. offsets: of the samples, as in sample_pattern().
    void resize(int width, int height, std::span<const glm::dvec2> offsets, Kept kept);

    [[nodiscard]] Kept kept() const noexcept { return kept_; }
    [[nodiscard]] int width() const noexcept { return width_; }
    [[nodiscard]] int height() const noexcept { return height_; }
    /// Returns the offsets of the samples.
    [[nodiscard]] std::span<const glm::dvec2> offsets() const { return offsets_; }

    /// Returns the hit at a sample; none if no surface is there. pixel: index, row by row.
    [[nodiscard]] std::optional<Hit> at(std::size_t sample, std::size_t pixel) const {
        const std::uint32_t texel = texels_[sample][pixel];
        if (texel == 0) return std::nullopt;
        return Hit{.triangle = (texel & ~kFront) - 1, .front = (texel & kFront) != 0};
    }
    /// Returns the value of a pixel without a surface, or of one with a hit.
    [[nodiscard]] static constexpr std::uint32_t texel(const std::optional<Hit>& hit) {
        return hit ? (hit->triangle + 1) | (hit->front ? kFront : 0) : 0;
    }
    /// Returns the texels of a sample on the host, one per pixel.
    [[nodiscard]] std::span<std::uint32_t> texels(std::size_t sample) { return texels_[sample]; }
    /// Returns the target of a sample on the device.
    [[nodiscard]] gl::RenderTarget& target(std::size_t sample) { return targets_[sample]; }
    /// Returns the texture that glsl/hits.glsl reads.
    [[nodiscard]] const gl::Texture2D& texture(std::size_t sample) const {
        return targets_[sample].colour(0);
    }

    /// Frees all memory.
    void clear();
    /// Returns the number of bytes that are kept outside the context.
    [[nodiscard]] std::uint64_t bytes() const;
    /// Returns the number of bytes per pixel that hits take, the context's memory included.
    [[nodiscard]] static std::uint64_t bytes_per_pixel(std::size_t samples, Kept kept) {
        const std::size_t targets = kept == Kept::on_host ? 1 : samples;
        const std::size_t read = kept == Kept::on_device ? 0 : samples;
        return read * sizeof(std::uint32_t) + targets * (sizeof(std::uint32_t) + sizeof(float));
    }

private:
    static constexpr std::uint32_t kFront = 0x80000000;  // must equal the value in hits.frag

    std::shared_ptr<gl::Context> context_;
    Kept kept_ = Kept::on_host;
    int width_ = 0, height_ = 0;
    std::span<const glm::dvec2> offsets_;
    std::vector<gl::RenderTarget> targets_;                             // by sample
    Stage<int, int, std::size_t> sizing_;                               // width, height, targets
    std::array<std::vector<std::uint32_t>, kMostPixelSamples> texels_;  // by sample
};

}  // namespace nicol
