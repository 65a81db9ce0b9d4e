// SPDX-License-Identifier: MIT
// shade at pixels on the device: the points that pixels show are shaded like vertices.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "devices/gl/device_light.hpp"
#include "devices/gl/device_pixel_image.hpp"
#include "devices/gl/device_points.hpp"
#include "draw/vertex_buffers.hpp"
#include "gl/program.hpp"
#include "methods/executor.hpp"

namespace nicol {

/// Which points the pixels of an image show, and the image from what was made of them.
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
        /// multiple of gl::kGroupOfVertices; and how many points it has.
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
    /// The listed points, as glsl/pixel_points.glsl has them.
    [[nodiscard]] const gl::Buffer& points() const { return points_.value(); }
    /// Makes the chunk's pixels: `stokes` are its points', by channel. `local_lights`, where the input has
    /// any: what they add to each pixel, by channel.
    void gather(const Chunk& chunk, std::span<const gl::Buffer* const> stokes,
                std::span<const std::vector<glm::vec4>> local_lights);
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

    Stage<std::size_t, bool> compiling_;  // samples, local lights
    std::optional<gl::Program> count_;
    std::optional<gl::Program> list_;
    std::optional<gl::Program> gather_;
    std::optional<gl::Buffer> offsets_;  // of samples
    Stage<Version, Version> grouping_;   // geometry, visibility
    std::optional<gl::Buffer> groups_;   // of triangles
    std::optional<gl::Buffer> points_;
    std::optional<gl::Buffer> shares_;
};

/// Points of one surface, side by side.
struct PixelRun {
    const VertexRange& surface;
    bool occluded;      ///< else nothing hides the light from the corners of their triangles
    std::size_t first;  ///< a multiple of gl::kGroupOfVertices
    std::size_t last;
};

/// All members inside run() of the context.
class DevicePixels {
public:
    /// `image` must outlive the object, and have the size of an image before it is shaded.
    DevicePixels(std::shared_ptr<gl::Context> context, DevicePixelImage& image);

    using Shade = std::function<void(const PixelRun&)>;
    /// Calls shade(run) until it was called for all points, at most `most` at once; it fills points().stokes,
    /// from which the image is made; local lights are added to it. Returns the number of points. Throws
    /// Error(unsupported) for more triangles or vertices than the driver lets a shader reach.
    std::uint64_t run(const PixelInput& input, VertexBuffers& buffers, std::size_t most, RenderRun& render,
                      const Shade& shade);

    /// While shade() runs: the points.
    [[nodiscard]] const DevicePoints& points() const noexcept { return points_; }
    /// The same points, as glsl/pixel_points.glsl has them.
    [[nodiscard]] const gl::Buffer& listed() const { return list_.points(); }
    /// A vec2 a point: the weights of its triangle's second and third corner.
    [[nodiscard]] const gl::Buffer& barycentric() const { return weights_.value(); }
    /// Memory for the light of its points, until the next call. Coefficients: of a point in a channel.
    [[nodiscard]] DeviceLight& light(const PixelRun& run, std::size_t coefficients, int channels);
    /// light = that of the vertices between which its points are, for all vertices of the surface after calls
    /// for all lights that have some of them, in ascending order. Others change nothing.
    void interpolate(const DeviceLight& vertices, const PixelRun& run, DeviceLight& light);

private:
    void release();
    void make_room_for(std::size_t points);
    void find_surface(const PixelRun& run);
    void interpolate_fractions(const PixelRun& run);
    // Expects source and result to be bound.
    void interpolate(const PixelRun& run, std::size_t coefficients);

    std::shared_ptr<gl::Context> context_;
    DevicePixelImage& image_;
    DevicePixelList list_;
    gl::Program surface_;
    gl::Program interpolate_;

    // Input of the image in work.
    const PixelInput* input_ = nullptr;
    VertexBuffers* buffers_ = nullptr;

    Stage<std::size_t, std::size_t, int> sizing_;  // width, height, channels
    std::optional<gl::Buffer> weights_;
    std::optional<gl::Buffer> positions_;
    std::optional<gl::Buffer> normals_;
    std::optional<gl::Buffer> fractions_;
    std::vector<std::optional<gl::Buffer>> stokes_;
    DevicePoints points_{};
    std::optional<DeviceLight> light_;
};

}  // namespace nicol
