// SPDX-License-Identifier: MIT
#include "render/aov_painter.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "render/aov_layout.hpp"

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

void AovPainter::prepare(const WorldGeometry& geometry, VertexBuffers& buffers, std::uint32_t mask,
                         Framebuffer& target) {
    attachments_.reset();
    mask_ = mask;
    if (mask == 0) {
        vertices_.reset();
        batches_.clear();
        binding_.reset();
        return;
    }
    binding_.run(buffers.version(), [&] { bind(geometry, buffers); });
    if (programs_.find(mask) == programs_.end()) {
        const std::vector<gl::Define> defines = defines_of(AovLayout(mask));
        programs_.emplace(mask, gl::Program::graphics(context_, "aovs.vert", "aovs.frag", defines));
    }
    attachments_ = target.aov_attachments(mask);
}

void AovPainter::bind(const WorldGeometry& geometry, VertexBuffers& buffers) {
    vertices_.reset();
    batches_.clear();
    if (!buffers.empty()) {
        const gl::Attribute attributes[] = {
            {.location = 0, .components = 3, .buffer = buffers.positions()},
            {.location = 1, .components = 3, .buffer = buffers.normals(geometry)}};
        vertices_.emplace(context_, attributes, buffers.indices());
        std::size_t range = 0;
        for (std::size_t i = 0; i < geometry.triangles.size(); ++i) {
            const std::size_t vertex = geometry.triangles[i].x;
            const bool another = batches_.empty() || vertex < geometry.ranges[range].first ||
                                 vertex >= geometry.ranges[range].last;
            if (another) {
                const auto found = std::ranges::upper_bound(geometry.ranges, vertex, {}, &VertexRange::last);
                range = static_cast<std::size_t>(found - geometry.ranges.begin());
                batches_.push_back({.instance = geometry.ranges[range].instance,
                                    .two_sided = i >= geometry.one_sided,
                                    .first = 3 * i,
                                    .last = 3 * i});
            }
            batches_.back().last = 3 * (i + 1);
        }
    }
}

void AovPainter::draw(const Projection& projection, const glm::dmat4& to_world,
                      std::span<const glm::dvec2> samples, Framebuffer& target) {
    if (mask_ != 0) {
        const AovLayout layout(mask_);
        gl::Program& program = programs_.at(mask_);
        if (program.uses("to_world")) program.set("to_world", glm::mat4(to_world));
        set_view_uniforms(program, projection.view);
        for (int i = 0; i < layout.attachments(); ++i) attachments_->clear_colour(i, layout.background(i));
        attachments_->clear_depth();
        // The depth test goes on from sample to sample and keeps the nearest.
        for (const glm::dvec2& sample : samples) {
            program.set("to_clip", glm::mat4(jittered(projection, sample).world_to_clip * to_world));
            for (const Batch& batch : batches_) {
                if (layout.instances >= 0) program.set("instance", batch.instance);
                gl::draw(*attachments_, program, *vertices_, batch.first, batch.last - batch.first,
                         {.cull = batch.two_sided ? gl::Cull::back : gl::Cull::none});
            }
        }
    }
    target.drew_aovs(mask_, std::move(attachments_));
    attachments_.reset();
}

}  // namespace nicol
