// SPDX-License-Identifier: MIT
#include "render/gpu/device_pixel_list.hpp"

#include <algorithm>
#include <glm/vec2.hpp>
#include <string>

#include "gl/draw.hpp"
#include "render/hit_image.hpp"

namespace nicol {
namespace {

constexpr std::size_t kPixelsOfBlock = 8192;  // pixels whose points are counted together
constexpr std::size_t kMostBlocks = 128;
constexpr std::size_t kMostPoints = 65536;  // of a chunk of several blocks

std::size_t in_whole_groups(std::size_t points) {
    return (points + kGroupOfVertices - 1) / kGroupOfVertices * kGroupOfVertices;
}

// Blocks that follow each other, from the numbers of points, [block][group].
std::vector<DevicePixelList::Chunk> chunks_of(std::span<const std::uint32_t> counts, std::size_t groups,
                                              std::size_t pixels) {
    std::vector<DevicePixelList::Chunk> chunks;
    for (std::size_t block = 0; block * groups < counts.size(); ++block) {
        const auto of_block = counts.subspan(block * groups, groups);
        std::size_t size = 0;
        for (const std::uint32_t points : of_block) size += in_whole_groups(points);
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
            begin += in_whole_groups(points);
        }
    }
    return chunks;
}

}  // namespace

std::vector<DevicePixelList::Chunk> DevicePixelList::find(const PixelInput& input, VertexBuffers& buffers,
                                                          DevicePixelImage& image) {
    input_ = &input;
    buffers_ = &buffers;
    image_ = &image;
    compile(input.hits.offsets(), input.small_lights != nullptr);
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
        offsets_ = storage(context_, std::vector<glm::vec2>(offsets.begin(), offsets.end()));
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
        groups_ = storage(context_, groups);
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

// Writes the coverage on the way.
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
        gl::dispatch(*count_, groups_for(last - first));
    }
    buffer.read(0, std::as_writable_bytes(std::span(counts)));
    return counts;
}

void DevicePixelList::list(const Chunk& chunk) {
    make_room(context_, points_, chunk.size * 4 * sizeof(float));
    make_room(context_, shares_,
              (chunk.last - chunk.first) * input_->hits.offsets().size() * sizeof(std::uint32_t));
    const gl::Buffer places = storage(context_, chunk.begin);
    bind_hits(*list_, chunk.first, chunk.last);
    places.bind_storage(3);
    points_->bind_storage(4);
    shares_->bind_storage(5);
    gl::dispatch(*list_, groups_for(chunk.last - chunk.first));
}

void DevicePixelList::gather(const Chunk& chunk, std::span<const gl::Buffer* const> stokes,
                             std::span<const std::vector<glm::vec4>> small_lights) {
    gather_->set("first", static_cast<int>(chunk.first));
    gather_->set("count", static_cast<int>(chunk.last - chunk.first));
    gather_->set("width", input_->hits.width());
    glm::vec4 wanted(0);
    for (std::size_t p = 0; p < input_->most_components; ++p) wanted[static_cast<glm::length_t>(p)] = 1;
    gather_->set("wanted", wanted);
    shares_->bind_storage(0);
    for (std::size_t c = 0; c < stokes.size(); ++c) {
        stokes[c]->bind_storage(1);
        std::optional<gl::Buffer> lights;
        if (input_->small_lights != nullptr) {
            lights = storage(context_, small_lights[c]);
            lights->bind_storage(2);
        }
        image_->channel(static_cast<int>(c)).bind_image();
        gl::dispatch(*gather_, groups_for(chunk.last - chunk.first));
    }
}

void DevicePixelList::release() {
    points_.reset();
    shares_.reset();
}

}  // namespace nicol
