// SPDX-License-Identifier: MIT
#include "devices/gl/device_textures.hpp"

#include <algorithm>
#include <string>

#include "draw/visibility_buffer.hpp"
#include "gl/draw.hpp"
#include "scene/projection.hpp"

namespace nicol {

void DeviceTextures::prepare(const PixelInput& input, VertexBuffers& buffers) {
    corners_ = &buffers.corners();
    copying_.run(input.materials, [&] {
        variations_.clear();
        for (const VertexRange& range : input.geometry.ranges)
            if (const SpatialVariation* const variation = range.material->variation())
                variations_.try_emplace(range.material, context_, *variation);
    });
    if (!variations_.empty())
        buffers.corners().update(input.geometry, input.versions.geometry, input.materials);
}

gl::Program& DeviceTextures::program(int textures) {
    auto found = programs_.find(textures);
    if (found == programs_.end()) {
        const gl::Define define{.name = "TEXTURES", .value = std::to_string(textures)};
        found =
            programs_.emplace(textures, gl::Program::compute(context_, "pixel_texture.comp", {&define, 1}))
                .first;
    }
    return found->second;
}

void DeviceTextures::find(const PixelInput& input, const PixelRun& run, const DevicePixels& pixels) {
    const VariationBuffers& variation = variations_.at(run.surface.material);
    const std::size_t count = run.last - run.first;
    stride_ = (count + gl::kGroupOfVertices - 1) / gl::kGroupOfVertices * gl::kGroupOfVertices;
    gl::make_room(context_, weights_, variation.layers() * stride_ * sizeof(glm::vec4));

    gl::Program& program = this->program(variation.textures());
    set_view_uniforms(program, input.view);
    const Projection& projection = input.projection;
    program.set("pixel_size",
                glm::vec2(2 * projection.texture_size * projection.half_width / input.hits.width(),
                          2 * projection.texture_size * projection.half_height / input.hits.height()));
    program.set("count", static_cast<int>(count));
    program.set("stride", static_cast<int>(stride_));
    program.set("corner_numbers", corners_->numbers());
    program.set("colored", corners_->colored() ? 1 : 0);
    program.set("with_tangents", corners_->with_tangents() ? 1 : 0);
    program.set("back", is_back(input.geometry, run.surface) ? 1 : 0);
    std::ignore = gl::bind_vertices(pixels.listed(), 0, 4, run.first, run.last);
    corners_->bind(1);
    std::ignore = gl::bind_vertices(pixels.barycentric(), 2, 2, run.first, run.last);
    std::ignore = gl::bind_vertices(*pixels.points().positions, 3, 3, run.first, run.last);
    std::ignore = gl::bind_vertices(*pixels.points().normals, 4, 3, run.first, run.last);
    variation.bind(5, 6);
    weights_->bind_storage(7);
    gl::dispatch(program, gl::groups_for(count));
}

const DevicePoints& DeviceTextures::layer_points(const DevicePoints& points) {
    make_room(context_, stokes_, points.stokes->step(), points.stokes->channels());
    points_ = points;
    points_.stokes = &*stokes_;
    return points_;
}

void DeviceTextures::add(std::size_t layer, const PixelRun& run, const DevicePoints& points) {
    if (!add_) add_ = gl::Program::compute(context_, "pixel_layer.comp");
    add_->set("count", static_cast<int>(run.last - run.first));
    add_->set("first_weight", static_cast<int>(layer * stride_));
    add_->set("add", layer > 0 ? 1 : 0);
    weights_->bind_storage(1);
    const StokesBuffer& result = *points.stokes;
    add_->set("from_channel", static_cast<int>(stokes_->step()));
    add_->set("to_channel", static_cast<int>(result.step()));
    const std::size_t largest = std::max(stokes_->channel_bytes(), result.channel_bytes());
    gl::for_independent_channels(*context_, result.channels(), largest, [&](gl::ChannelGroup channels) {
        add_->set("first_channel", channels.first);
        std::ignore = stokes_->bind(0, channels, run.first, run.last);
        std::ignore = result.bind(2, channels, run.first, run.last);
        gl::dispatch(*add_, gl::groups_for(run.last - run.first), 1, static_cast<unsigned>(channels.count));
    });
}

}  // namespace nicol
