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
            groups.push_back(2 * static_cast<std::uint32_t>(surface) + (any ? 1 : 0));
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
    const gl::Buffer buffer(context_, gl::BufferUse::storage, counts.size() * sizeof(std::uint32_t),
                            gl::BufferUpdate::fixed);
    constexpr std::size_t step = kMostBlocks * kPixelsOfBlock;
    for (std::size_t first = 0; first < pixels; first += step) {
        const std::size_t last = std::min(first + step, pixels);
        bind_hits(*count_, first, last);
        count_->set("block", static_cast<int>(kPixelsOfBlock));
        count_->set("group_count", static_cast<int>(groups));
        buffer.bind_storage(3);
        image_->coverage().bind_image();
        gl::dispatch(*count_, gl::groups_for(last - first));
    }
    buffer.read(0, std::as_writable_bytes(std::span(counts)));
    return counts;
}

void DevicePixelList::list(const Chunk& chunk) {
    gl::make_room(context_, points_, chunk.size * 4 * sizeof(float));
    gl::make_room(context_, shares_,
                  (chunk.last - chunk.first) * input_->hits.offsets().size() * sizeof(std::uint32_t));
    const gl::Buffer places = gl::storage(context_, chunk.begin);
    bind_hits(*list_, chunk.first, chunk.last);
    places.bind_storage(3);
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
    shares_->bind_storage(0);
    const gl::IndependentDispatches of_channels(*context_);
    for (int c = 0; c < stokes.channels(); ++c) {
        std::ignore = stokes.bind(1, {.first = c, .count = 1}, 0, stokes.step());
        std::optional<gl::Buffer> lights;
        if (input_->local_lights != nullptr) {
            lights = gl::storage(context_, local_lights[static_cast<std::size_t>(c)]);
            lights->bind_storage(2);
        }
        image_->channel(c).bind_image();
        gl::dispatch(*gather_, gl::groups_for(chunk.last - chunk.first));
    }
}

void DevicePixelList::release() {
    points_.reset();
    shares_.reset();
}

DevicePixels::DevicePixels(std::shared_ptr<gl::Context> context, DevicePixelImage& image)
    : context_(std::move(context)),
      image_(image),
      list_(context_),
      surface_(gl::Program::compute(context_, "pixel_surface.comp")),
      interpolate_light_(gl::Program::compute(context_, "pixel_interpolate.comp")),
      interpolate_fractions_(gl::Program::compute(context_, "pixel_interpolate.comp")) {}

std::uint64_t DevicePixels::run(const PixelInput& input, VertexBuffers& buffers, std::size_t most,
                                RenderRun& render, const Shade& shade, const Finish& finish) {
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

void DevicePixels::find_surface(const PixelRun& run) {
    const Projection& projection = input_->projection;
    set_view_uniforms(surface_, input_->view);
    surface_.set("width", input_->hits.width());
    surface_.set("size", glm::vec2(input_->hits.width(), input_->hits.height()));
    surface_.set("half_size", glm::vec2(projection.half_width, projection.half_height));
    surface_.set("shift", glm::vec2(projection.shift));
    surface_.set("count", static_cast<int>(run.last - run.first));
    std::ignore = gl::bind_vertices(list_.points(), 0, 4, run.first, run.last);
    buffers_->indices()->buffer().bind_storage(1);
    const std::size_t first =
        gl::bind_vertices(*buffers_->positions(), 2, 3, run.surface.first, run.surface.last);
    std::ignore =
        gl::bind_vertices(*buffers_->normals(input_->geometry), 3, 3, run.surface.first, run.surface.last);
    surface_.set("first_vertex", static_cast<int>(first));
    std::ignore = gl::bind_vertices(*positions_, 4, 3, run.first, run.last);
    std::ignore = gl::bind_vertices(*normals_, 5, 3, run.first, run.last);
    std::ignore = gl::bind_vertices(*weights_, 6, 2, run.first, run.last);
    gl::dispatch(surface_, gl::groups_for(run.last - run.first));
}

DeviceLight& DevicePixels::light(const PixelRun& run, std::size_t coefficients, int channels) {
    const std::size_t count = run.last - run.first;
    if (!light_ || light_->coefficients() != coefficients || light_->channels() != channels ||
        light_->stride() < count) {
        light_.reset();
        light_.emplace(context_, run.first, count, coefficients, channels);
    }
    light_->place(run.first, count);
    return *light_;
}

void DevicePixels::interpolate(const DeviceLight& vertices, const PixelRun& run, DeviceLight& light) {
    if (vertices.last() <= run.surface.first || vertices.first() >= run.surface.last) return;
    interpolate_light_.set("first_vertex", static_cast<int>(vertices.first()));
    interpolate_light_.set("last_vertex", static_cast<int>(vertices.last()));
    interpolate_light_.set("add", vertices.first() > run.surface.first ? 1 : 0);
    interpolate_light_.set("from_number", static_cast<int>(vertices.stride()));
    interpolate_light_.set("from_vertex", 1);
    interpolate_light_.set("to_number", static_cast<int>(light.stride()));
    interpolate_light_.set("to_point", 1);
    interpolate_light_.set("from_channel", static_cast<int>(vertices.channel_step()));
    interpolate_light_.set("to_channel", static_cast<int>(light.channel_step()));
    const std::size_t largest = std::max(vertices.channel_bytes(), light.channel_bytes());
    gl::for_independent_channels(*context_, light.channels(), largest, [&](gl::ChannelGroup channels) {
        vertices.bind(3, channels);
        light.bind(4, channels);
        interpolate(interpolate_light_, run, light.coefficients(), channels.count);
    });
}

void DevicePixels::interpolate_fractions(const PixelRun& run) {
    const std::size_t first =
        gl::bind_vertices(*buffers_->fractions(), 3, 2, run.surface.first, run.surface.last);
    std::ignore = gl::bind_vertices(*fractions_, 4, 2, run.first, run.last);
    interpolate_fractions_.set("first_vertex", static_cast<int>(first));
    interpolate_fractions_.set("last_vertex", static_cast<int>(run.surface.last));
    interpolate_fractions_.set("add", 0);
    interpolate_fractions_.set("from_number", 1);
    interpolate_fractions_.set("from_vertex", 2);
    interpolate_fractions_.set("to_number", 1);
    interpolate_fractions_.set("to_point", 2);
    interpolate(interpolate_fractions_, run, 2, 1);
}

void DevicePixels::interpolate(gl::Program& program, const PixelRun& run, std::size_t coefficients,
                               int channels) {
    program.set("count", static_cast<int>(run.last - run.first));
    std::ignore = gl::bind_vertices(list_.points(), 0, 4, run.first, run.last);
    buffers_->indices()->buffer().bind_storage(1);
    std::ignore = gl::bind_vertices(*weights_, 2, 2, run.first, run.last);
    gl::dispatch(program, gl::groups_for(run.last - run.first), static_cast<unsigned>(coefficients),
                 static_cast<unsigned>(channels));
}

}  // namespace nicol
