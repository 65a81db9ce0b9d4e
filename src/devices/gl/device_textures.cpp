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
    stokes_.resize(points.stokes.size());
    points_ = points;
    for (std::size_t c = 0; c < stokes_.size(); ++c) {
        gl::make_room(context_, stokes_[c], points.stokes[c]->size());
        points_.stokes[c] = &*stokes_[c];
    }
    return points_;
}

void DeviceTextures::add(std::size_t layer, const PixelRun& run, const DevicePoints& points) {
    if (!add_) add_ = gl::Program::compute(context_, "pixel_layer.comp");
    add_->set("count", static_cast<int>(run.last - run.first));
    add_->set("first_weight", static_cast<int>(layer * stride_));
    add_->set("add", layer > 0 ? 1 : 0);
    weights_->bind_storage(1);
    const gl::IndependentDispatches of_channels(*context_);
    for (std::size_t c = 0; c < points.stokes.size(); ++c) {
        // A point's three weights are equal if the image does not have three channels.
        add_->set("channel", static_cast<int>(std::min<std::size_t>(c, 2)));
        std::ignore = gl::bind_vertices(*stokes_[c], 0, 4, run.first, run.last);
        std::ignore = gl::bind_vertices(*points.stokes[c], 2, 4, run.first, run.last);
        gl::dispatch(*add_, gl::groups_for(run.last - run.first));
    }
}

}  // namespace nicol
