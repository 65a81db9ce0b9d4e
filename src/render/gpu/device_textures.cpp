// SPDX-License-Identifier: MIT
#include "render/gpu/device_textures.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "error.hpp"
#include "gl/context.hpp"
#include "gl/draw.hpp"
#include "render/hit_image.hpp"
#include "scene/projection.hpp"
#include "shading/normal_variation.hpp"

namespace nicol {

void DeviceTextures::prepare(const PixelInput& input) {
    copying_corners_.run(input.versions.geometry, input.materials, [&] { copy_corners(input.geometry); });
    copying_variations_.run(input.materials, [&] {
        variations_.clear();
        for (const VertexRange& range : input.geometry.ranges)
            if (const SpatialVariation* const variation = range.material->variation())
                variations_.try_emplace(range.material, context_, *variation);
    });
}

// As glsl/pixel_texture.comp reads them.
void DeviceTextures::copy_corners(const WorldGeometry& geometry) {
    corners_.reset();
    const bool colored = !geometry.colors.empty();
    corner_numbers_ = colored ? 21 : 12;
    const std::size_t numbers = geometry.triangles.size() * static_cast<std::size_t>(corner_numbers_);
    const std::size_t most = context_->limits().storage_bytes / sizeof(float);
    if (numbers > most)
        throw Error(ErrorCode::unsupported,
                    "compute shaders of " + context_->info().renderer + " texture at most " +
                        std::to_string(most / static_cast<std::size_t>(corner_numbers_)) +
                        " triangles, and the scene has " + std::to_string(geometry.triangles.size()) +
                        "; set executor to cpu");
    std::vector<float> all;
    all.reserve(numbers);
    for (std::size_t t = 0; t < geometry.triangles.size(); ++t) {
        std::array<glm::vec2, 3> texcoords{};
        if (!geometry.texcoords.empty()) texcoords = geometry.texcoords[t];
        for (const glm::vec2& uv : texcoords) all.insert(all.end(), {uv.x, uv.y});
        const glm::uvec3& c = geometry.triangles[t];
        const TextureAxes axes = texture_axes(
            {geometry.positions[c.x], geometry.positions[c.y], geometry.positions[c.z]}, texcoords);
        for (const glm::vec3& axis : {axes.by_u, axes.by_v}) all.insert(all.end(), {axis.x, axis.y, axis.z});
        if (!colored) continue;
        for (const glm::vec3& color : geometry.colors[t]) all.insert(all.end(), {color.x, color.y, color.z});
    }
    if (!all.empty()) corners_.emplace(storage(context_, all));
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
    const DeviceVariation& variation = variations_.at(run.surface.material);
    const std::size_t count = run.last - run.first;
    stride_ = (count + kGroupOfVertices - 1) / kGroupOfVertices * kGroupOfVertices;
    make_room(context_, weights_, variation.layers() * stride_ * sizeof(glm::vec4));

    gl::Program& program = this->program(variation.textures());
    set_view_uniforms(program, input.view);
    const Projection& projection = input.projection;
    program.set("pixel_size", glm::vec2(2 * projection.half_width / input.hits.width(),
                                        2 * projection.half_height / input.hits.height()));
    program.set("count", static_cast<int>(count));
    program.set("stride", static_cast<int>(stride_));
    program.set("corner_numbers", corner_numbers_);
    program.set("colored", input.geometry.colors.empty() ? 0 : 1);
    program.set("back", is_back(input.geometry, run.surface) ? 1 : 0);
    std::ignore = bind_vertices(pixels.listed(), 0, 4, run.first, run.last);
    corners_->bind_storage(1);
    std::ignore = bind_vertices(pixels.barycentric(), 2, 2, run.first, run.last);
    std::ignore = bind_vertices(*pixels.points().positions, 3, 3, run.first, run.last);
    std::ignore = bind_vertices(*pixels.points().normals, 4, 3, run.first, run.last);
    variation.bind(5, 6);
    weights_->bind_storage(7);
    gl::dispatch(program, groups_for(count));
}

const DevicePoints& DeviceTextures::layer_points(const DevicePoints& points) {
    stokes_.resize(points.stokes.size());
    points_ = points;
    for (std::size_t c = 0; c < stokes_.size(); ++c) {
        make_room(context_, stokes_[c], points.stokes[c]->size());
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
    for (std::size_t c = 0; c < points.stokes.size(); ++c) {
        // Three equal ones where there are not three channels.
        add_->set("channel", static_cast<int>(std::min<std::size_t>(c, 2)));
        std::ignore = bind_vertices(*stokes_[c], 0, 4, run.first, run.last);
        std::ignore = bind_vertices(*points.stokes[c], 2, 4, run.first, run.last);
        gl::dispatch(*add_, groups_for(run.last - run.first));
    }
}

}  // namespace nicol
