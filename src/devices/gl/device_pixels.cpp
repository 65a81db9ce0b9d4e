// SPDX-License-Identifier: MIT
#include "devices/gl/device_pixels.hpp"

#include <algorithm>
#include <glm/vec2.hpp>
#include <string>

#include "devices/light_image.hpp"
#include "draw/visibility_buffer.hpp"
#include "error.hpp"
#include "gl/context.hpp"
#include "gl/draw.hpp"
#include "methods/high_orders.hpp"
#include "scene/projection.hpp"

namespace nicol {
namespace {

constexpr std::size_t kPixelsOfBlock = 8192;  // pixels whose points are counted together
constexpr std::size_t kMostBlocks = 128;
constexpr std::size_t kMostPoints = 65536;  // limit for a chunk of several blocks

// Returns chunks of consecutive blocks. counts: numbers of points, [block][group].
std::vector<DevicePixelList::Chunk> chunks_of(std::span<const std::uint32_t> counts, std::size_t groups,
                                              std::size_t pixels) {
    std::vector<DevicePixelList::Chunk> chunks;
    for (std::size_t block = 0; block * groups < counts.size(); ++block) {
        const auto of_block = counts.subspan(block * groups, groups);
        std::size_t size = 0;
        for (const std::uint32_t points : of_block) size += gl::in_whole_groups(points);
        const std::size_t first = block * kPixelsOfBlock;
        if (chunks.empty() || chunks.back().size + size > kMostPoints ||
            first - chunks.back().first == kMostBlocks * kPixelsOfBlock) {
            chunks.push_back({.first = first, .last = first, .begin = {}, .counts = {}, .size = 0});
            chunks.back().counts.resize(groups);
        }
        DevicePixelList::Chunk& chunk = chunks.back();
        chunk.last = std::min(first + kPixelsOfBlock, pixels);
        chunk.size += size;
        for (std::size_t g = 0; g < groups; ++g) chunk.counts[g] += of_block[g];
    }
    for (DevicePixelList::Chunk& chunk : chunks) {
        std::size_t begin = 0;
        for (const std::uint32_t points : chunk.counts) {
            chunk.begin.push_back(static_cast<std::uint32_t>(begin));
            begin += gl::in_whole_groups(points);
        }
    }
    return chunks;
}

// Returns the points of a chunk in stretches of at most `most`. A stretch has one run, or all that follow
// each other and may be joined.
std::vector<PixelStretch> stretches_of(const DevicePixelList::Chunk& chunk, const WorldGeometry& geometry,
                                       std::size_t most, DevicePixels::Joins joins) {
    std::vector<PixelStretch> stretches;
    const std::size_t ranges = geometry.ranges.size();
    bool open = false;  // whether the last stretch may grow
    for (std::size_t g = 0; g < chunk.counts.size(); ++g) {
        const VertexRange& surface = geometry.ranges[g % ranges];
        const bool occluded = g >= ranges;
        const bool joined = joins == DevicePixels::Joins::plain && surface.material->variation() == nullptr;
        const std::size_t last = chunk.begin[g] + chunk.counts[g];
        for (std::size_t first = chunk.begin[g]; first < last; first += most) {
            const std::size_t end = std::min(first + most, last);
            if (!open || !joined || end - stretches.back().first() > most) stretches.emplace_back();
            open = joined;
            stretches.back().runs.push_back(
                {.surface = surface, .occluded = occluded, .first = first, .last = end});
        }
    }
    return stretches;
}

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

std::vector<DevicePixelList::Chunk> DevicePixelList::find(const PixelInput& input, VertexBuffers& buffers,
                                                          DevicePixelImage& image) {
    input_ = &input;
    buffers_ = &buffers;
    image_ = &image;
    compile(input.hits.offsets(), input.local_lights != nullptr);
    find_groups();
    const std::size_t pixels =
        static_cast<std::size_t>(input.hits.width()) * static_cast<std::size_t>(input.hits.height());
    return chunks_of(count(pixels), 2 * input.geometry.ranges.size(), pixels);
}

void DevicePixelList::compile(std::span<const glm::dvec2> offsets, bool lit) {
    compiling_.run(offsets.size(), lit, [&] {
        const auto program = [&](const char* file, std::vector<gl::Define> defines) {
            defines.push_back({.name = "SAMPLES", .value = std::to_string(offsets.size())});
            return gl::Program::compute(context_, file, defines);
        };
        using Defines = std::vector<gl::Define>;
        count_ = program("pixel_collect.comp", {});
        list_ = program("pixel_collect.comp", {{.name = "LISTING"}});
        gather_ = program("pixel_gather.comp", lit ? Defines{{.name = "LIT"}} : Defines());
        offsets_ = gl::storage(context_, std::vector<glm::vec2>(offsets.begin(), offsets.end()));
    });
}

void DevicePixelList::find_groups() {
    const PixelInput& input = *input_;
    grouping_.run(input.versions.geometry, input.versions.visibility, [&] {
        const auto ranges = static_cast<std::uint32_t>(input.geometry.ranges.size());
        std::vector<std::uint32_t> groups;
        groups.reserve(input.geometry.triangles.size());
        const auto occluded = [&](std::uint32_t v) {
            return input.visibility != nullptr && !input.visibility->unoccluded(v);
        };
        for (const glm::uvec3& t : input.geometry.triangles) {
            const auto surface =
                std::ranges::upper_bound(input.geometry.ranges, t.x, {}, &VertexRange::last) -
                input.geometry.ranges.begin();
            const bool any = occluded(t.x) || occluded(t.y) || occluded(t.z);
            groups.push_back(static_cast<std::uint32_t>(surface) + (any ? ranges : 0));
        }
        groups_ = gl::storage(context_, groups);
    });
}

void DevicePixelList::bind_hits(gl::Program& program, std::size_t first, std::size_t last) {
    program.set("first", static_cast<int>(first));
    program.set("count", static_cast<int>(last - first));
    program.set("width", input_->hits.width());
    buffers_->indices()->buffer().bind_storage(0);
    groups_->bind_storage(1);
    offsets_->bind_storage(2);
    for (std::size_t s = 0; s < input_->hits.offsets().size(); ++s)
        input_->hits.texture(s).bind(static_cast<unsigned>(s));
}

// Counts the points, [block][group], and writes the coverage, too.
std::vector<std::uint32_t> DevicePixelList::count(std::size_t pixels) {
    const std::size_t groups = 2 * input_->geometry.ranges.size();
    std::vector<std::uint32_t> counts((pixels + kPixelsOfBlock - 1) / kPixelsOfBlock * groups);
    gl::write(context_, counts_, counts);
    constexpr std::size_t step = kMostBlocks * kPixelsOfBlock;
    for (std::size_t first = 0; first < pixels; first += step) {
        const std::size_t last = std::min(first + step, pixels);
        bind_hits(*count_, first, last);
        count_->set("block", static_cast<int>(kPixelsOfBlock));
        count_->set("group_count", static_cast<int>(groups));
        counts_->bind_storage(3);
        image_->coverage().bind_image();
        gl::dispatch(*count_, gl::groups_for(last - first));
    }
    counts_->read(0, std::as_writable_bytes(std::span(counts)));
    return counts;
}

void DevicePixelList::list(const Chunk& chunk) {
    gl::make_room(context_, points_, chunk.size * 4 * sizeof(float));
    gl::make_room(context_, shares_,
                  (chunk.last - chunk.first) * input_->hits.offsets().size() * sizeof(std::uint32_t));
    gl::write(context_, places_, chunk.begin);
    bind_hits(*list_, chunk.first, chunk.last);
    places_->bind_storage(3);
    points_->bind_storage(4);
    shares_->bind_storage(5);
    gl::dispatch(*list_, gl::groups_for(chunk.last - chunk.first));
}

void DevicePixelList::gather(const Chunk& chunk, const StokesBuffer& stokes,
                             std::span<const std::vector<glm::vec4>> local_lights) {
    gather_->set("first", static_cast<int>(chunk.first));
    gather_->set("count", static_cast<int>(chunk.last - chunk.first));
    gather_->set("width", input_->hits.width());
    glm::vec4 wanted(0);
    for (std::size_t p = 0; p < input_->most_components; ++p) wanted[static_cast<glm::length_t>(p)] = 1;
    gather_->set("wanted", wanted);
    const std::size_t pixels = chunk.last - chunk.first;
    gather_->set("stokes_step", static_cast<int>(stokes.step()));
    std::size_t largest = stokes.channel_bytes();
    if (input_->local_lights != nullptr) {
        upload(local_lights, pixels);
        gather_->set("lights_step", static_cast<int>(lights_->step()));
        largest = std::max(largest, lights_->channel_bytes());
    }
    shares_->bind_storage(0);
    image_->channels().bind_image();
    gl::for_independent_channels(*context_, stokes.channels(), largest, [&](gl::ChannelGroup channels) {
        gather_->set("first_channel", channels.first);
        std::ignore = stokes.bind(1, channels, 0, stokes.step());
        if (input_->local_lights != nullptr) std::ignore = lights_->bind(2, channels, 0, pixels);
        gl::dispatch(*gather_, gl::groups_for(pixels), 1, static_cast<unsigned>(channels.count));
    });
}

void DevicePixelList::upload(std::span<const std::vector<glm::vec4>> local_lights, std::size_t pixels) {
    const auto channels = static_cast<int>(local_lights.size());
    if (!lights_ || lights_->step() < pixels || lights_->channels() != channels) {
        lights_.reset();
        lights_.emplace(context_, gl::BufferUse::storage, gl::BufferUpdate::dynamic, pixels, channels);
    }
    for (int c = 0; c < channels; ++c) {
        const auto of_channel = std::span(local_lights[static_cast<std::size_t>(c)]).first(pixels);
        lights_->buffer()->update(lights_->offset(c), std::as_bytes(of_channel));
    }
}

void DevicePixelList::release() {
    for (std::optional<gl::Buffer>* const buffer : {&counts_, &places_, &points_, &shares_}) buffer->reset();
    lights_.reset();
}

DevicePixels::DevicePixels(std::shared_ptr<gl::Context> context, DevicePixelImage& image)
    : context_(std::move(context)),
      image_(image),
      list_(context_),
      surface_(gl::Program::compute(context_, "pixel_surface.comp")),
      interpolate_light_(gl::Program::compute(context_, "pixel_interpolate.comp")),
      interpolate_fractions_(gl::Program::compute(context_, "pixel_interpolate.comp")) {}

std::uint64_t DevicePixels::run(const PixelInput& input, VertexBuffers& buffers, std::size_t most,
                                Joins joins, RenderRun& render, const Shade& shade, const Finish& finish) {
    check_size(*context_, input.geometry);
    input_ = &input;
    buffers_ = &buffers;
    const auto width = static_cast<std::size_t>(input.hits.width());
    const auto height = static_cast<std::size_t>(input.hits.height());
    sizing_.run(width, height, input.channels, [&] { release(); });
    std::uint64_t shaded = 0;
    std::vector<std::vector<glm::vec4>> local_lights;  // light at the pixels of a chunk, by channel
    for (const DevicePixelList::Chunk& chunk : list_.find(input, buffers, image_)) {
        render.progress.report("shade",
                               static_cast<double>(chunk.first) / static_cast<double>(width * height));
        make_room_for(chunk.size);
        list_.list(chunk);
        if (chunk.size > 0) {  // else the pixels show backs alone
            find_surfaces(chunk.size);
            if (points_.fractions != nullptr) interpolate_fractions(chunk.size);
        }
        for (const PixelStretch& stretch : stretches_of(chunk, input.geometry, most, joins)) shade(stretch);
        for (const std::uint32_t points : chunk.counts) shaded += points;
        finish(chunk.size);
        // Threads compute local lights while the device, which has all of its input, shades this chunk.
        if (input.local_lights != nullptr) {
            gl::flush(*context_);
            find_light_image(input, chunk.first, chunk.last, render, local_lights);
        }
        list_.gather(chunk, *points_.stokes, local_lights);
    }
    return shaded;
}

void DevicePixels::release() {
    list_.release();
    for (std::optional<gl::Buffer>* const buffer : {&weights_, &positions_, &normals_, &fractions_})
        buffer->reset();
    stokes_.reset();
    light_.reset();
}

void DevicePixels::make_room_for(std::size_t points) {
    const auto floats = [&](std::optional<gl::Buffer>& buffer, std::size_t of_point) {
        gl::make_room(context_, buffer, points * of_point * sizeof(float));
    };
    floats(weights_, 2);
    floats(positions_, 3);
    floats(normals_, 3);
    const bool shadows = input_->high_orders != nullptr && !input_->high_orders->visibility()->empty();
    if (shadows) floats(fractions_, 2);
    make_room(context_, stokes_, points, input_->channels);
    points_ = {.positions = &*positions_,
               .normals = &*normals_,
               .fractions = shadows ? &*fractions_ : nullptr,
               .stokes = &*stokes_};
}

void DevicePixels::find_surfaces(std::size_t points) {
    const Projection& projection = input_->projection;
    set_view_uniforms(surface_, input_->view);
    surface_.set("width", input_->hits.width());
    surface_.set("size", glm::vec2(input_->hits.width(), input_->hits.height()));
    surface_.set("half_size", glm::vec2(projection.half_width, projection.half_height));
    surface_.set("shift", glm::vec2(projection.shift));
    surface_.set("count", static_cast<int>(points));
    list_.points().bind_storage(0);
    buffers_->indices()->buffer().bind_storage(1);
    buffers_->positions()->bind_storage(2);
    buffers_->normals(input_->geometry)->bind_storage(3);
    positions_->bind_storage(4);
    normals_->bind_storage(5);
    weights_->bind_storage(6);
    gl::dispatch(surface_, gl::groups_for(points));
}

DeviceLight& DevicePixels::light(std::size_t first, std::size_t last, std::size_t coefficients,
                                 int channels) {
    const std::size_t count = last - first;
    if (!light_ || light_->coefficients() != coefficients || light_->channels() != channels ||
        light_->stride() < count) {
        light_.reset();
        light_.emplace(context_, first, count, coefficients, channels);
    }
    light_->place(first, count);
    return *light_;
}

void DevicePixels::interpolate(const DeviceLight& vertices, bool add, std::size_t first, DeviceLight& light) {
    interpolate_light_.set("first_vertex", static_cast<int>(vertices.first()));
    interpolate_light_.set("last_vertex", static_cast<int>(vertices.last()));
    interpolate_light_.set("add", add ? 1 : 0);
    interpolate_light_.set("from_number", static_cast<int>(vertices.stride()));
    interpolate_light_.set("from_vertex", 1);
    interpolate_light_.set("to_number", static_cast<int>(light.stride()));
    interpolate_light_.set("to_point", 1);
    interpolate_light_.set("from_channel", static_cast<int>(vertices.channel_step()));
    interpolate_light_.set("to_channel", static_cast<int>(light.channel_step()));
    interpolate_light_.set("to_first", static_cast<int>(first - light.first()));
    const std::size_t largest = std::max(vertices.channel_bytes(), light.channel_bytes());
    gl::for_independent_channels(*context_, light.channels(), largest, [&](gl::ChannelGroup channels) {
        vertices.bind(3, channels);
        light.bind(4, channels);
        interpolate(interpolate_light_, first, light.last(), light.coefficients(), channels.count);
    });
}

void DevicePixels::interpolate_fractions(std::size_t points) {
    buffers_->fractions()->bind_storage(3);
    fractions_->bind_storage(4);
    interpolate_fractions_.set("first_vertex", 0);
    interpolate_fractions_.set("last_vertex", static_cast<int>(input_->geometry.positions.size()));
    interpolate_fractions_.set("add", 0);
    interpolate_fractions_.set("from_number", 1);
    interpolate_fractions_.set("from_vertex", 2);
    interpolate_fractions_.set("to_number", 1);
    interpolate_fractions_.set("to_point", 2);
    interpolate_fractions_.set("to_first", 0);
    interpolate(interpolate_fractions_, 0, points, 2, 1);
}

void DevicePixels::interpolate(gl::Program& program, std::size_t first, std::size_t last,
                               std::size_t coefficients, int channels) {
    program.set("count", static_cast<int>(last - first));
    std::ignore = gl::bind_vertices(list_.points(), 0, 4, first, last);
    buffers_->indices()->buffer().bind_storage(1);
    std::ignore = gl::bind_vertices(*weights_, 2, 2, first, last);
    gl::dispatch(program, gl::groups_for(last - first), static_cast<unsigned>(coefficients),
                 static_cast<unsigned>(channels));
}

}  // namespace nicol
