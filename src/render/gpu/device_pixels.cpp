// SPDX-License-Identifier: MIT
#include "render/gpu/device_pixels.hpp"

#include <algorithm>
#include <glm/vec2.hpp>
#include <string>

#include "error.hpp"
#include "gl/context.hpp"
#include "gl/draw.hpp"
#include "render/cpu/light_image.hpp"
#include "render/high_orders.hpp"
#include "render/hit_image.hpp"
#include "scene/projection.hpp"

namespace nicol {
namespace {

void check_size(const gl::Context& context, const WorldGeometry& geometry) {
    const std::size_t most = context.limits().storage_bytes / sizeof(glm::vec3);
    if (std::max(geometry.triangles.size(), geometry.positions.size()) <= most) return;
    throw Error(ErrorCode::unsupported,
                "compute shaders of " + context.info().renderer + " shade at pixels of at most " +
                    std::to_string(most) + " triangles and vertices, and the scene has " +
                    std::to_string(geometry.triangles.size()) + " and " +
                    std::to_string(geometry.positions.size()) + "; shade at vertices, or by threads");
}

}  // namespace

DevicePixels::DevicePixels(std::shared_ptr<gl::Context> context, DevicePixelImage& image)
    : context_(std::move(context)),
      image_(image),
      list_(context_),
      surface_(gl::Program::compute(context_, "pixel_surface.comp")),
      interpolate_(gl::Program::compute(context_, "pixel_interpolate.comp")) {}

std::uint64_t DevicePixels::run(const PixelInput& input, VertexBuffers& buffers, std::size_t most,
                                RenderRun& render, const Shade& shade) {
    check_size(*context_, input.geometry);
    input_ = &input;
    buffers_ = &buffers;
    const auto width = static_cast<std::size_t>(input.hits.width());
    const auto height = static_cast<std::size_t>(input.hits.height());
    sizing_.run(width, height, input.channels, [&] { release(); });
    std::uint64_t shaded = 0;
    std::vector<std::vector<glm::vec4>> small_lights;  // of the pixels of a chunk, by channel
    for (const DevicePixelList::Chunk& chunk : list_.find(input, buffers, image_)) {
        render.progress.report("shade",
                               static_cast<double>(chunk.first) / static_cast<double>(width * height));
        make_room_for(chunk.size);
        list_.list(chunk);
        for (std::size_t g = 0; g < chunk.counts.size(); ++g) {
            const std::size_t last = chunk.begin[g] + chunk.counts[g];
            for (std::size_t first = chunk.begin[g]; first < last; first += most) {
                const PixelRun run{.surface = input.geometry.ranges[g / 2],
                                   .occluded = g % 2 != 0,
                                   .first = first,
                                   .last = std::min(first + most, last)};
                find_surface(run);
                if (points_.fractions != nullptr) interpolate_fractions(run);
                shade(run);
            }
            shaded += chunk.counts[g];
        }
        // Threads work beside the device, which has what it needs of this chunk.
        if (input.small_lights != nullptr) {
            gl::flush(*context_);
            find_light_image(input, chunk.first, chunk.last, render, small_lights);
        }
        list_.gather(chunk, points_.stokes, small_lights);
    }
    return shaded;
}

void DevicePixels::release() {
    list_.release();
    for (std::optional<gl::Buffer>* const buffer : {&weights_, &positions_, &normals_, &fractions_})
        buffer->reset();
    stokes_.clear();
    light_.reset();
}

void DevicePixels::make_room_for(std::size_t points) {
    const auto floats = [&](std::optional<gl::Buffer>& buffer, std::size_t of_point) {
        make_room(context_, buffer, points * of_point * sizeof(float));
    };
    floats(weights_, 2);
    floats(positions_, 3);
    floats(normals_, 3);
    const bool shadows = input_->high_orders != nullptr && !input_->high_orders->visibility()->empty();
    if (shadows) floats(fractions_, 2);
    stokes_.resize(static_cast<std::size_t>(input_->channels));
    for (std::optional<gl::Buffer>& channel : stokes_) floats(channel, 4);
    points_ = {.positions = &*positions_,
               .normals = &*normals_,
               .fractions = shadows ? &*fractions_ : nullptr,
               .stokes = {}};
    for (const std::optional<gl::Buffer>& channel : stokes_) points_.stokes.push_back(&*channel);
}

void DevicePixels::find_surface(const PixelRun& run) {
    const Projection& projection = input_->projection;
    set_view_uniforms(surface_, input_->view);
    surface_.set("width", input_->hits.width());
    surface_.set("size", glm::vec2(input_->hits.width(), input_->hits.height()));
    surface_.set("half_size", glm::vec2(projection.half_width, projection.half_height));
    surface_.set("shift", glm::vec2(projection.shift));
    surface_.set("count", static_cast<int>(run.last - run.first));
    std::ignore = bind_vertices(list_.points(), 0, 4, run.first, run.last);
    buffers_->indices()->buffer().bind_storage(1);
    const std::size_t first =
        bind_vertices(*buffers_->positions(), 2, 3, run.surface.first, run.surface.last);
    std::ignore =
        bind_vertices(*buffers_->normals(input_->geometry), 3, 3, run.surface.first, run.surface.last);
    surface_.set("first_vertex", static_cast<int>(first));
    std::ignore = bind_vertices(*positions_, 4, 3, run.first, run.last);
    std::ignore = bind_vertices(*normals_, 5, 3, run.first, run.last);
    std::ignore = bind_vertices(*weights_, 6, 2, run.first, run.last);
    gl::dispatch(surface_, groups_for(run.last - run.first));
}

DeviceLight& DevicePixels::light(const PixelRun& run, std::size_t numbers, int channels) {
    const std::size_t count = run.last - run.first;
    if (!light_ || light_->numbers() != numbers || light_->channels() != channels ||
        light_->stride() < count) {
        light_.reset();
        light_.emplace(context_, run.first, count, numbers, channels);
    }
    light_->place(run.first, count);
    return *light_;
}

void DevicePixels::interpolate(const DeviceLight& vertices, const PixelRun& run, DeviceLight& light) {
    if (vertices.last() <= run.surface.first || vertices.first() >= run.surface.last) return;
    interpolate_.set("first_vertex", static_cast<int>(vertices.first()));
    interpolate_.set("last_vertex", static_cast<int>(vertices.last()));
    interpolate_.set("add", vertices.first() > run.surface.first ? 1 : 0);
    interpolate_.set("from_number", static_cast<int>(vertices.stride()));
    interpolate_.set("from_vertex", 1);
    interpolate_.set("to_number", static_cast<int>(light.stride()));
    interpolate_.set("to_point", 1);
    for (int c = 0; c < light.channels(); ++c) {
        vertices.bind(3, c);
        light.bind(4, c);
        interpolate(run, light.numbers());
    }
}

void DevicePixels::interpolate_fractions(const PixelRun& run) {
    const std::size_t first =
        bind_vertices(*buffers_->fractions(), 3, 2, run.surface.first, run.surface.last);
    std::ignore = bind_vertices(*fractions_, 4, 2, run.first, run.last);
    interpolate_.set("first_vertex", static_cast<int>(first));
    interpolate_.set("last_vertex", static_cast<int>(run.surface.last));
    interpolate_.set("add", 0);
    interpolate_.set("from_number", 1);
    interpolate_.set("from_vertex", 2);
    interpolate_.set("to_number", 1);
    interpolate_.set("to_point", 2);
    interpolate(run, 2);
}

void DevicePixels::interpolate(const PixelRun& run, std::size_t numbers) {
    interpolate_.set("count", static_cast<int>(run.last - run.first));
    std::ignore = bind_vertices(list_.points(), 0, 4, run.first, run.last);
    buffers_->indices()->buffer().bind_storage(1);
    std::ignore = bind_vertices(*weights_, 2, 2, run.first, run.last);
    gl::dispatch(interpolate_, groups_for(run.last - run.first), static_cast<unsigned>(numbers));
}

}  // namespace nicol
