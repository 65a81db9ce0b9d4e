// SPDX-License-Identifier: MIT
#include "draw/visibility_buffer.hpp"

#include <glm/mat4x4.hpp>
#include <span>

namespace nicol {

void VisibilityBuffer::draw(const WorldGeometry& geometry, VertexBuffers& buffers,
                            const AlphaMasks& alpha_masks, const Projection& projection, int width,
                            int height, std::span<const glm::dvec2> offsets, Kept kept) {
    batching_.run(buffers.version(), alpha_masks.version(), [&] { find_batches(geometry, alpha_masks); });
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
        draw_sample(alpha_masks, projection, s, target);
        if (kept == Kept::on_device) continue;
        texels.resize(pixels);
        target.read(0, texels);
    }
}

// Merges the batches of surfaces without alpha masks, for as few draws as possible.
void VisibilityBuffer::find_batches(const WorldGeometry& geometry, const AlphaMasks& alpha_masks) {
    batches_.clear();
    for (const TriangleBatch& batch : triangle_batches(geometry)) {
        const bool joins = !batches_.empty() && batches_.back().two_sided == batch.two_sided &&
                           alpha_masks.textures(batches_.back().range) == 0 &&
                           alpha_masks.textures(batch.range) == 0;
        if (joins)
            batches_.back().last = batch.last;
        else
            batches_.push_back(batch);
    }
}

gl::Program& VisibilityBuffer::program(int textures) {
    auto found = programs_.find(textures);
    if (found == programs_.end()) {
        const std::vector<gl::Define> defines = AlphaMasks::defines(textures);
        found =
            programs_.emplace(textures, gl::Program::graphics(context_, "hits.vert", "hits.frag", defines))
                .first;
    }
    return found->second;
}

void VisibilityBuffer::draw_sample(const AlphaMasks& alpha_masks, const Projection& projection,
                                   std::size_t sample, gl::RenderTarget& target) {
    const glm::mat4 to_clip(jittered(projection, offsets_[sample]).world_to_clip);
    target.clear();
    if (!vertices_) return;
    for (const TriangleBatch& batch : batches_) {
        const int textures = alpha_masks.textures(batch.range);
        gl::Program& program = this->program(textures);
        program.set("to_clip", to_clip);
        program.set("first", static_cast<std::uint32_t>(batch.first));
        if (textures > 0) alpha_masks.bind(program, batch.range, sample, offsets_.size());
        // Each side of a two-sided surface has its own triangles.
        gl::draw(target, program, *vertices_, 3 * batch.first, 3 * (batch.last - batch.first),
                 {.cull = batch.two_sided ? gl::Cull::back : gl::Cull::none});
    }
}

void VisibilityBuffer::clear() {
    targets_.clear();
    sizing_.reset();
    texels_ = {};
}

std::uint64_t VisibilityBuffer::bytes() const {
    std::uint64_t bytes = 0;
    for (const std::vector<std::uint32_t>& texels : texels_) bytes += texels.size() * sizeof(std::uint32_t);
    return bytes;
}

}  // namespace nicol
