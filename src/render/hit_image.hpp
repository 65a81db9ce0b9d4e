// SPDX-License-Identifier: MIT
// draw, where pixels are shaded: which triangle is at each pixel's centre.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "gl/draw.hpp"
#include "gl/program.hpp"
#include "gl/render_target.hpp"
#include "render/vertex_buffers.hpp"
#include "versioned.hpp"

namespace nicol {

/// A triangle of a WorldGeometry, and whether the camera sees its front.
struct Hit {
    std::uint32_t triangle;
    bool front;
};

class HitImage {
public:
    explicit HitImage(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// `buffers` are of `geometry`. Inside run() of the context.
    void draw(const WorldGeometry& geometry, VertexBuffers& buffers, const glm::dmat4& to_clip, int width,
              int height);

    /// Of the last draw(): for shaders, texels that read() copies and of() decodes.
    [[nodiscard]] const gl::Texture2D& texture() const { return target_->colour(0); }
    /// Row by row. Throws what run() of the context does.
    void read(std::vector<glm::vec4>& texels) const;
    /// Nothing where no surface is.
    [[nodiscard]] static std::optional<Hit> of(const glm::vec4& texel);

    [[nodiscard]] int width() const { return target_->width(); }
    [[nodiscard]] int height() const { return target_->height(); }

private:
    std::shared_ptr<gl::Context> context_;
    std::optional<gl::Program> program_;
    std::optional<gl::RenderTarget> target_;
    std::optional<gl::VertexArray> vertices_;
    Stage<Version> binding_;
};

}  // namespace nicol
