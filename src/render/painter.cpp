// SPDX-License-Identifier: MIT
#include "render/painter.hpp"

#include <algorithm>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <utility>

namespace nicol {
namespace {

int group_size(int channels, std::size_t group) {
    return std::min(Framebuffer::kGroup, channels - static_cast<int>(group) * Framebuffer::kGroup);
}

gl::TextureDescription equirect(const EquirectImage& picture) {
    return {.width = picture.width,
            .height = picture.height,
            .filter = gl::Filter::linear,
            .wrap_x = gl::Wrap::repeat,
            .wrap_y = gl::Wrap::clamp};
}

}  // namespace

Painter::Painter(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

void Painter::draw(const Scene& scene, const VertexBuffers& buffers, std::size_t one_sided,
                   const Projection& projection, Framebuffer& target) {
    const int channels = target.channels();
    if (buffers_revision_ != buffers.revision() || channels_ != channels) bind_vertices(buffers, channels);
    if (environment_ != scene.environment() || channels_ != channels) {
        upload_environment(scene.environment().get(), channels);
    }
    buffers_revision_ = buffers.revision();
    environment_ = scene.environment();
    channels_ = channels;

    for (std::size_t g = 0; g < groups_.size(); ++g) {
        gl::RenderTarget& picture = target.groups()[g];
        gl::Program& surface = program("surface.vert", "surface.frag", group_size(channels, g), false);
        surface.set("world_to_clip", glm::mat4(projection.world_to_clip));
        if (environment_) {
            picture.clear_depth();
        } else {
            picture.clear();
        }
        if (!groups_[g].vertices) continue;
        // Materials without a back are drawn black from behind, the others have triangles for each side.
        const std::size_t first = 3 * one_sided;
        const std::size_t two_sided = groups_[g].vertices->index_count() - first;
        gl::draw(picture, surface, *groups_[g].vertices, 0, first);
        gl::draw(picture, surface, *groups_[g].vertices, first, two_sided, {.cull = gl::Cull::back});
    }
    if (environment_) draw_background(scene, projection, target);
    gl::finish(*context_);
}

gl::Program& Painter::program(const char* vertex, const char* fragment, int channels, bool polarized) {
    const auto key = std::make_tuple(std::string(fragment), channels, polarized);
    auto found = programs_.find(key);
    if (found == programs_.end()) {
        std::vector<gl::Define> defines{{.name = "CHANNELS", .value = std::to_string(channels)}};
        if (polarized) defines.push_back({.name = "POLARIZED"});
        found = programs_.emplace(key, gl::Program::graphics(context_, vertex, fragment, defines)).first;
    }
    return found->second;
}

void Painter::bind_vertices(const VertexBuffers& buffers, int channels) {
    const auto count = static_cast<std::size_t>((channels + Framebuffer::kGroup - 1) / Framebuffer::kGroup);
    groups_.resize(count);
    for (std::size_t g = 0; g < count; ++g) {
        groups_[g].vertices.reset();
        if (buffers.empty()) continue;
        std::vector<gl::Attribute> attributes{
            {.location = 0, .components = 3, .buffer = buffers.positions()}};
        for (int c = 0; c < group_size(channels, g); ++c) {
            attributes.push_back({.location = static_cast<unsigned>(1 + c),
                                  .components = 4,
                                  .buffer = buffers.stokes(static_cast<int>(g) * Framebuffer::kGroup + c)});
        }
        groups_[g].vertices.emplace(context_, attributes, buffers.indices());
    }
}

void Painter::upload_environment(const Environment* environment, int channels) {
    for (Group& group : groups_) group.environment.clear();
    if (environment == nullptr) return;
    const EquirectImage picture = environment->picture();
    const std::size_t pixels =
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    const auto channel_data = [&](int c) {
        const auto from = static_cast<std::size_t>(picture.channels == 1 ? 0 : c) * 4 * pixels;
        return std::span(picture.data).subspan(from, 4 * pixels);
    };
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        const int first = static_cast<int>(g) * Framebuffer::kGroup;
        if (environment->polarized()) {
            for (int c = 0; c < group_size(channels, g); ++c) {
                groups_[g].environment.emplace_back(context_, equirect(picture), channel_data(first + c));
            }
            continue;
        }
        std::vector<float> packed(4 * pixels);
        for (int c = 0; c < group_size(channels, g); ++c) {
            const std::span<const float> from = channel_data(first + c);
            for (std::size_t i = 0; i < pixels; ++i)
                packed[4 * i + static_cast<std::size_t>(c)] = from[4 * i];
        }
        groups_[g].environment.emplace_back(context_, equirect(picture), packed);
    }
}

void Painter::draw_background(const Scene& scene, const Projection& projection, Framebuffer& target) {
    const bool polarized = scene.environment()->polarized();
    const Viewpoint& view = projection.view;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        gl::Program& sky =
            program("fullscreen.vert", "background.frag", group_size(target.channels(), g), polarized);
        sky.set("camera", glm::mat3(view.right, view.up, view.forward));
        sky.set("half_size", glm::vec2(projection.half_width, projection.half_height));
        sky.set("orthographic", view.orthographic ? 1 : 0);
        sky.set("to_light", glm::mat3(glm::transpose(scene.light_rotation())));
        sky.set("scale", static_cast<float>(scene.light_scale()));
        for (std::size_t i = 0; i < groups_[g].environment.size(); ++i) {
            groups_[g].environment[i].bind(static_cast<unsigned>(i));
        }
        gl::draw_fullscreen(target.groups()[g], sky,
                            {.depth_test = gl::DepthTest::less_equal, .depth_write = false});
    }
}

}  // namespace nicol
