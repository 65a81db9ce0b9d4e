// SPDX-License-Identifier: MIT
#include "render/hit_image.hpp"

#include <glm/mat4x4.hpp>
#include <span>

namespace nicol {

void HitImage::draw(const WorldGeometry& geometry, VertexBuffers& buffers, const Projection& projection,
                    int width, int height, std::span<const glm::dvec2> offsets, Kept kept) {
    if (!program_) program_ = gl::Program::graphics(context_, "hits.vert", "hits.frag", {});
    const std::size_t targets = kept == Kept::on_host ? 1 : offsets.size();
    sizing_.run(width, height, targets, [&] {
        targets_.clear();
        for (std::size_t i = 0; i < targets; ++i)
            targets_.emplace_back(
                context_,
                gl::RenderTargetDescription{.width = width, .height = height, .format = gl::Format::r32ui});
    });
    binding_.run(buffers.version(), [&] {
        vertices_.reset();
        if (buffers.empty()) return;
        const gl::Attribute positions[] = {{.location = 0, .components = 3, .buffer = buffers.positions()}};
        vertices_.emplace(context_, positions, buffers.indices());
    });
    offsets_ = offsets;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    for (std::size_t s = 0; s < kMostPixelSamples; ++s) {
        std::vector<std::uint32_t>& texels = texels_[s];
        if (s >= offsets.size() || kept == Kept::on_device) texels = {};
        if (s >= offsets.size()) continue;
        gl::RenderTarget& target = targets_[kept == Kept::on_host ? 0 : s];
        draw_sample(geometry, jittered(projection, offsets[s]).world_to_clip, target);
        if (kept == Kept::on_device) continue;
        texels.resize(pixels);
        target.read(0, texels);
    }
}

void HitImage::draw_sample(const WorldGeometry& geometry, const glm::dmat4& to_clip,
                           gl::RenderTarget& target) {
    target.clear();
    if (!vertices_) return;
    program_->set("to_clip", glm::mat4(to_clip));
    const auto draw_some = [&](std::size_t first, std::size_t last, gl::Cull cull) {
        if (first == last) return;
        program_->set("first", static_cast<std::uint32_t>(first));
        gl::draw(target, *program_, *vertices_, 3 * first, 3 * (last - first), {.cull = cull});
    };
    // Of two-sided surfaces each side has triangles of its own.
    draw_some(0, geometry.one_sided, gl::Cull::none);
    draw_some(geometry.one_sided, geometry.triangles.size(), gl::Cull::back);
}

void HitImage::clear() {
    targets_.clear();
    sizing_.reset();
    texels_ = {};
}

std::uint64_t HitImage::bytes() const {
    std::uint64_t bytes = 0;
    for (const std::vector<std::uint32_t>& texels : texels_) bytes += texels.size() * sizeof(std::uint32_t);
    return bytes;
}

}  // namespace nicol
