// SPDX-License-Identifier: MIT
// An image to draw into: colour textures and an optional depth buffer.
#pragma once

#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <vector>

#include "gl/borrowed_texture.hpp"
#include "gl/texture.hpp"

namespace nicol::gl {

struct RenderTargetDescription {
    int width = 0, height = 0;  ///< pixels, 1 .. Limits::target_size
    int colours = 1;            ///< colour attachments, 1 .. Limits::colour_attachments
    bool depth = true;          ///< whether there is a 32-bit float depth buffer
    Format format = Format::rgba32f;
};

/// Textures that are not ours: first levels of GL_TEXTURE_2D.
struct BorrowedTextures {
    unsigned colour = 0;
    BorrowedFormats formats = BorrowedFormats::colours;
    unsigned depth = 0;  ///< texture of a depth format, with or without stencil; 0: none
};

/// A framebuffer with its attachments. Row 0 is the top of the image, in memory, in the textures, and in
/// gl_FragCoord (whose y grows downwards). The context's clip origin is the upper left, so clip space keeps y
/// up, counter-clockwise triangles stay front faces, and nothing is ever flipped. Depth runs from 0 to 1 over
/// clip z from -w to w. All members must be called inside run(). Construction throws Error(invalid_argument)
/// outside the limits, Error(out_of_memory) if the driver cannot hold it, Error(opengl) if the framebuffer is
/// incomplete. The initial content is zero, depth 1.
class RenderTarget {
public:
    RenderTarget(const std::shared_ptr<Context>& context, const RenderTargetDescription& description);

    /// Uses these textures, of one size and format, as colour attachments, with depth.
    explicit RenderTarget(std::vector<Texture2D> colours);

    /// Uses textures that are not ours, which must have one size and outlive the target. Throws
    /// Error(invalid_argument) that names the texture which cannot be drawn into.
    RenderTarget(const std::shared_ptr<Context>& context, const BorrowedTextures& borrowed);

    /// Clears every colour attachment, and depth to 1. Integer attachments are always cleared to 0.
    void clear(const glm::vec4& colour = glm::vec4(0.0f));
    void clear_colour(int attachment, const glm::vec4& colour);
    void clear_depth(float depth = 0.0f);

    /// Copies one attachment, top row first, as Texture2D::read() does.
    void read(int attachment, std::span<float> pixels) const;
    void read(int attachment, std::span<std::uint32_t> pixels) const;
    /// Replaces the texels of one attachment, top row first.
    void write(int attachment, std::span<const float> pixels);

    /// Returns an attachment for sampling in a later pass, never in a pass that draws into it. Not available
    /// for a borrowed texture.
    [[nodiscard]] const Texture2D& colour(int attachment) const;
    [[nodiscard]] Texture2D& colour(int attachment);
    [[nodiscard]] int width() const noexcept { return description_.width; }
    [[nodiscard]] int height() const noexcept { return description_.height; }
    [[nodiscard]] int colours() const noexcept { return description_.colours; }
    [[nodiscard]] bool has_depth() const noexcept { return description_.depth; }
    [[nodiscard]] unsigned id() const noexcept { return framebuffer_.id(); }
    [[nodiscard]] const std::shared_ptr<Context>& context() const noexcept { return framebuffer_.context(); }

private:
    void attach();

    RenderTargetDescription description_;
    std::vector<Texture2D> colours_;
    std::vector<Object> depth_;  ///< one renderbuffer or none
    Object framebuffer_;         ///< declared after its attachments, so that it is destroyed first
};

}  // namespace nicol::gl
