// SPDX-License-Identifier: MIT
#include "draw/drawn_hits.hpp"

#include <glm/mat4x4.hpp>

#include "gl/draw.hpp"

namespace nicol {

void DrawnHits::find(const HitRequest& request, VisibilityBuffer& out) {
    batching_.run(buffers_.version(), alpha_masks_.version(),
                  [&] { find_batches(request.surfaces.geometry()); });
    binding_.run(buffers_.version(), [&] { context_->run([&] { bind(); }); });
    out.resize(request.width, request.height, request.offsets, request.kept);
    const bool on_device = request.kept != VisibilityBuffer::Kept::on_host;
    for (std::size_t s = 0; s < request.offsets.size(); ++s) {
        context_->run([&] {
            gl::RenderTarget& target = on_device ? out.target(s) : read_back(request.width, request.height);
            draw(request, s, target);
            if (request.kept != VisibilityBuffer::Kept::on_device) target.read(0, out.texels(s));
        });
    }
    if (on_device) clear();
}

void DrawnHits::bind() {
    vertices_.reset();
    if (buffers_.empty()) return;
    const gl::Attribute positions[] = {{.location = 0, .components = 3, .buffer = buffers_.positions()}};
    vertices_.emplace(context_, positions, buffers_.indices());
}

// Merges the batches of surfaces without alpha masks, for as few draws as possible.
void DrawnHits::find_batches(const WorldGeometry& geometry) {
    batches_.clear();
    for (const TriangleBatch& batch : triangle_batches(geometry)) {
        const bool joins = !batches_.empty() && batches_.back().two_sided == batch.two_sided &&
                           alpha_masks_.textures(batches_.back().range) == 0 &&
                           alpha_masks_.textures(batch.range) == 0;
        if (joins)
            batches_.back().last = batch.last;
        else
            batches_.push_back(batch);
    }
}

gl::RenderTarget& DrawnHits::read_back(int width, int height) {
    if (!read_back_ || read_back_->width() != width || read_back_->height() != height) {
        read_back_.reset();
        read_back_.emplace(context_, gl::RenderTargetDescription{
                                         .width = width, .height = height, .format = gl::Format::r32ui});
    }
    return *read_back_;
}

gl::Program& DrawnHits::program(int textures) {
    auto found = programs_.find(textures);
    if (found == programs_.end()) {
        const std::vector<gl::Define> defines = AlphaMasks::defines(textures);
        found =
            programs_.emplace(textures, gl::Program::graphics(context_, "hits.vert", "hits.frag", defines))
                .first;
    }
    return found->second;
}

void DrawnHits::draw(const HitRequest& request, std::size_t sample, gl::RenderTarget& target) {
    const glm::mat4 to_clip(jittered(request.projection, request.offsets[sample]).world_to_clip);
    target.clear();
    if (!vertices_) return;
    for (const TriangleBatch& batch : batches_) {
        const int textures = alpha_masks_.textures(batch.range);
        gl::Program& program = this->program(textures);
        program.set("to_clip", to_clip);
        program.set("first", static_cast<std::uint32_t>(batch.first));
        if (textures > 0) alpha_masks_.bind(program, batch.range, sample, request.offsets.size());
        // Each side of a two-sided surface has its own triangles.
        gl::draw(target, program, *vertices_, 3 * batch.first, 3 * (batch.last - batch.first),
                 {.cull = batch.two_sided ? gl::Cull::back : gl::Cull::none});
    }
}

}  // namespace nicol
