// SPDX-License-Identifier: MIT
#include "draw/aov_painter.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "draw/aov_layout.hpp"
#include "surfaces/rigid_motion.hpp"

namespace nicol {
namespace {

std::vector<gl::Define> defines_of(const AovLayout& layout) {
    std::vector<gl::Define> defines{{.name = "ATTACHMENTS", .value = std::to_string(layout.attachments())}};
    const auto define = [&](const char* name, int place) {
        if (place >= 0) defines.push_back({.name = name, .value = std::to_string(place)});
    };
    define("NORMALS", layout.normals);
    define("DEPTH", layout.depth);
    define("POSITIONS", layout.positions);
    define("INSTANCES", layout.instances);
    define("ALPHA", layout.alpha);
    return defines;
}

}  // namespace

glm::vec4 AovLayout::background(int attachment) const {
    glm::vec4 values(0.0F);
    const auto set = [&](int place, float value) {
        if (place >= 0 && place / 4 == attachment) values[place % 4] = value;
    };
    set(depth, std::numeric_limits<float>::infinity());
    if (instances >= 0) {
        set(instances, static_cast<float>(kNoInstance & 0xffff));
        set(instances + 1, static_cast<float>(kNoInstance >> 16));
    }
    return values;
}

void AovPainter::prepare(const WorldGeometry& geometry, VertexBuffers& buffers, const AlphaMasks& alpha_masks,
                         std::uint32_t mask, std::span<const glm::dvec2> samples, Framebuffer& target) {
    attachments_.reset();
    mask_ = mask;
    samples_ = samples;
    const bool nearest = samples.size() > 1 && (mask & (aov_positions | aov_instances)) != 0;
    drawn_ = nearest ? mask | aov_depth : mask;
    if (mask == 0) {
        sample_.reset();
        vertices_.reset();
        batches_.clear();
        binding_.reset();
        return;
    }
    binding_.run(buffers.version(), [&] { bind(geometry, buffers); });
    for (const Batch& batch : batches_)
        program("aovs.vert", "aovs.frag", alpha_masks.textures(batch.triangles.range));
    if (samples.size() > 1) program("fullscreen.vert", "aovs_merge.frag");
    attachments_ = target.aov_attachments(drawn_);
    prepare_sample();
}

gl::Program& AovPainter::program(const char* vertex, const char* fragment, int textures) {
    const std::tuple key(std::string(fragment), drawn_, textures);
    auto found = programs_.find(key);
    if (found == programs_.end()) {
        std::vector<gl::Define> defines = defines_of(AovLayout(drawn_));
        for (gl::Define& define : AlphaMasks::defines(textures)) defines.push_back(std::move(define));
        found = programs_.emplace(key, gl::Program::graphics(context_, vertex, fragment, defines)).first;
    }
    return found->second;
}

void AovPainter::prepare_sample() {
    const gl::RenderTargetDescription wanted{
        .width = attachments_->width(), .height = attachments_->height(), .colours = attachments_->colours()};
    const bool several = samples_.size() > 1;
    if (several && sample_ && sample_->width() == wanted.width && sample_->height() == wanted.height &&
        sample_->colours() == wanted.colours)
        return;
    sample_.reset();
    if (several) sample_.emplace(context_, wanted);
}

void AovPainter::bind(const WorldGeometry& geometry, VertexBuffers& buffers) {
    vertices_.reset();
    batches_.clear();
    if (!buffers.empty()) {
        const gl::Attribute attributes[] = {
            {.location = 0, .components = 3, .buffer = buffers.positions()},
            {.location = 1, .components = 3, .buffer = buffers.normals(geometry)}};
        vertices_.emplace(context_, attributes, buffers.indices());
        for (const TriangleBatch& batch : triangle_batches(geometry))
            batches_.push_back({.triangles = batch, .instance = geometry.ranges[batch.range].instance});
    }
}

void AovPainter::draw(const AlphaMasks& alpha_masks, const Projection& projection, const glm::dmat4& to_world,
                      Framebuffer& target) {
    if (mask_ != 0) {
        clear(*attachments_);
        for (std::size_t s = 0; s < samples_.size(); ++s) {
            if (sample_) clear(*sample_);
            draw_surfaces(alpha_masks, projection, s, to_world, sample_ ? *sample_ : *attachments_);
            if (sample_) merge(s);
        }
    }
    target.drew_aovs(mask_, drawn_, std::move(attachments_));
    attachments_.reset();
}

void AovPainter::clear(gl::RenderTarget& image) const {
    const AovLayout layout(drawn_);
    for (int i = 0; i < image.colours(); ++i) image.clear_colour(i, layout.background(i));
    image.clear_depth();
}

void AovPainter::draw_surfaces(const AlphaMasks& alpha_masks, const Projection& projection,
                               std::size_t sample, const glm::dmat4& to_world, gl::RenderTarget& image) {
    const Projection of_axes = in_axes(jittered(projection, samples_[sample]), to_world);
    const glm::mat4 to_clip(of_axes.world_to_clip);
    gl::Program* whole = nullptr;
    const auto program_of = [&](int textures) -> gl::Program& {
        if (textures == 0 && whole != nullptr) return *whole;
        gl::Program& surface = program("aovs.vert", "aovs.frag", textures);
        if (surface.uses("to_world")) surface.set("to_world", glm::mat4(to_world));
        set_view_uniforms(surface, of_axes.view);
        surface.set("to_clip", to_clip);
        if (textures == 0) whole = &surface;
        return surface;
    };
    for (const Batch& batch : batches_) {
        const TriangleBatch& triangles = batch.triangles;
        const int textures = alpha_masks.textures(triangles.range);
        gl::Program& surface = program_of(textures);
        if ((drawn_ & aov_instances) != 0) surface.set("instance", batch.instance);
        if (textures > 0) {
            surface.set("first", static_cast<std::uint32_t>(triangles.first));
            alpha_masks.bind(surface, triangles.range, sample, samples_.size());
        }
        gl::draw(image, surface, *vertices_, 3 * triangles.first, 3 * (triangles.last - triangles.first),
                 {.cull = triangles.two_sided ? gl::Cull::back : gl::Cull::none});
    }
}

void AovPainter::merge(std::size_t sample) {
    gl::Program& merging = program("fullscreen.vert", "aovs_merge.frag");
    if (merging.uses("weight")) merging.set("weight", 1.0F / static_cast<float>(samples_.size()));
    if (merging.uses("last")) merging.set("last", sample + 1 == samples_.size() ? 1 : 0);
    for (int i = 0; i < sample_->colours(); ++i) {
        sample_->colour(i).bind(static_cast<unsigned>(i));
        attachments_->colour(i).bind(static_cast<unsigned>(4 + i));
    }
    gl::texture_barrier(*context_);
    gl::draw_fullscreen(*attachments_, merging);
}

}  // namespace nicol
