// SPDX-License-Identifier: MIT
// Which points the pixels of an image show, on the device, and the image from what was made of them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gl/program.hpp"
#include "render/executor.hpp"
#include "render/gpu/device_light.hpp"
#include "render/gpu/device_pixel_image.hpp"
#include "render/vertex_buffers.hpp"

namespace nicol {

/// The points are those that PixelShading of threads finds. They are listed for some pixels at a time, those
/// of a group side by side: of one of the geometry's surfaces, with or without an occluded corner. Only the
/// numbers of points come back to the host. All members inside run() of the context.
class DevicePixelList {
public:
    explicit DevicePixelList(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Pixels whose points are listed together.
    struct Chunk {
        std::size_t first;
        std::size_t last;
        /// By group, twice the surface and 1 where a corner is occluded: its first point in the list, a
        /// multiple of kGroupOfVertices; and how many points it has.
        std::vector<std::uint32_t> begin;
        std::vector<std::uint32_t> counts;
        std::size_t size;  ///< of the list
    };

    /// Counts the points of an image and writes its coverage. What is passed must live until the last
    /// gather().
    [[nodiscard]] std::vector<Chunk> find(const PixelInput& input, VertexBuffers& buffers,
                                          DevicePixelImage& image);
    /// Makes the list of a chunk.
    void list(const Chunk& chunk);
    /// By glsl/pixel_points.glsl.
    [[nodiscard]] const gl::Buffer& points() const { return points_.value(); }
    /// Makes the chunk's pixels: `stokes` are its points', by channel. `small_lights`, where the input has
    /// any: what they add to each pixel, by channel.
    void gather(const Chunk& chunk, std::span<const gl::Buffer* const> stokes,
                std::span<const std::vector<glm::vec4>> small_lights);
    /// Gives the memory of the last list back.
    void release();

private:
    void compile(std::span<const glm::dvec2> offsets, bool lit);
    void find_groups();
    void bind_hits(gl::Program& program, std::size_t first, std::size_t last);
    [[nodiscard]] std::vector<std::uint32_t> count(std::size_t pixels);

    std::shared_ptr<gl::Context> context_;
    const PixelInput* input_ = nullptr;
    VertexBuffers* buffers_ = nullptr;
    DevicePixelImage* image_ = nullptr;

    Stage<std::size_t, bool> compiling_;  // samples, small lights
    std::optional<gl::Program> count_;
    std::optional<gl::Program> list_;
    std::optional<gl::Program> gather_;
    std::optional<gl::Buffer> offsets_;  // of samples
    Stage<Version, Version> grouping_;   // geometry, visibility
    std::optional<gl::Buffer> groups_;   // of triangles
    std::optional<gl::Buffer> points_;
    std::optional<gl::Buffer> shares_;
};

}  // namespace nicol
