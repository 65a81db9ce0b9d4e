// SPDX-License-Identifier: MIT
#include "render/hit_image.hpp"

#include <glm/mat4x4.hpp>
#include <span>

namespace nicol {

void HitImage::draw(const WorldGeometry& geometry, VertexBuffers& buffers, const glm::dmat4& to_clip,
                    int width, int height) {
    if (!program_) program_ = gl::Program::graphics(context_, "hits.vert", "hits.frag", {});
    if (!target_ || target_->width() != width || target_->height() != height) {
        target_.reset();
        target_.emplace(context_, gl::RenderTargetDescription{.width = width, .height = height});
    }
    binding_.run(buffers.version(), [&] {
        vertices_.reset();
        if (buffers.empty()) return;
        const gl::Attribute positions[] = {{.location = 0, .components = 3, .buffer = buffers.positions()}};
        vertices_.emplace(context_, positions, buffers.indices());
    });
    target_->clear();
    if (!vertices_) return;
    program_->set("to_clip", glm::mat4(to_clip));
    const auto draw_some = [&](std::size_t first, std::size_t last, gl::Cull cull) {
        if (first == last) return;
        program_->set("first", static_cast<std::uint32_t>(first));
        gl::draw(*target_, *program_, *vertices_, 3 * first, 3 * (last - first), {.cull = cull});
    };
    // Of two-sided surfaces each side has triangles of its own.
    draw_some(0, geometry.one_sided, gl::Cull::none);
    draw_some(geometry.one_sided, geometry.triangles.size(), gl::Cull::back);
}

void HitImage::read(std::vector<glm::vec4>& texels) const {
    texels.resize(static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()));
    context_->run([&] { target_->read(0, std::span(&texels.front().x, 4 * texels.size())); });
}

std::optional<Hit> HitImage::of(const glm::vec4& texel) {
    if (texel.y == 0) return std::nullopt;
    const auto low = static_cast<std::uint32_t>(texel.x);
    const auto high = static_cast<std::uint32_t>(texel.y) - 1;
    return Hit{.triangle = high << 16 | low, .front = texel.z != 0};
}

}  // namespace nicol
