// SPDX-License-Identifier: MIT
// shade at pixels on the device: the points that pixels show, as a list that is shaded like vertices.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "gl/program.hpp"
#include "render/executor.hpp"
#include "render/gpu/device_light.hpp"
#include "render/gpu/device_points.hpp"
#include "render/gpu/device_pixel_image.hpp"

namespace nicol {

/// Points of one surface, side by side.
struct PixelRun {
    const VertexRange& surface;
    bool occluded;      ///< else nothing hides the light from the corners of their triangles
    std::size_t first;  ///< a multiple of kGroupOfVertices
    std::size_t last;
};

/// Which points there are is what PixelShading of threads finds. Only their numbers come back to the host.
/// All members inside run() of the context.
class DevicePixels {
public:
    /// `image` must outlive the object, and have the size of an image before it is shaded.
    DevicePixels(std::shared_ptr<gl::Context> context, DevicePixelImage& image);

    using Shade = std::function<void(const PixelRun&)>;
    /// Calls shade(run) until it was called for all points, at most `most` at once; it fills points().stokes,
    /// from which the image is made. Returns the number of points. Throws Error(unsupported) for more
    /// triangles or vertices than the driver lets a shader reach.
    std::uint64_t run(const PixelInput& input, VertexBuffers& buffers, std::size_t most, Progress& progress,
                      const Shade& shade);

    /// While shade() runs: the points.
    [[nodiscard]] const DevicePoints& points() const noexcept { return points_; }
    /// Memory for the light of its points, until the next call. Numbers: of a point in a channel.
    [[nodiscard]] DeviceLight& light(const PixelRun& run, std::size_t numbers, int channels);
    /// light = that of the vertices between which its points are, for all vertices of the surface after calls
    /// for all lights that have some of them, in ascending order. Others change nothing.
    void interpolate(const DeviceLight& vertices, const PixelRun& run, DeviceLight& light);

private:
    // Pixels whose points are listed at once.
    struct Chunk {
        std::size_t first;
        std::size_t last;
        std::vector<std::uint32_t> begin;   // of each group, in the list
        std::vector<std::uint32_t> counts;  // points of each group
        std::size_t size;                   // of the list
    };

    void compile(std::size_t samples);
    void find_groups(const PixelInput& input);
    void bind_hits(gl::Program& program, std::size_t first, std::size_t last);
    [[nodiscard]] std::vector<std::uint32_t> count();
    [[nodiscard]] static std::vector<Chunk> chunks(std::span<const std::uint32_t> counts, std::size_t groups,
                                                   std::size_t pixels);
    void release();
    void make_room(std::size_t points, std::size_t shares);
    void list(const Chunk& chunk);
    void find_surface(const PixelRun& run);
    void interpolate_fractions(const PixelRun& run);
    // Expects source and result to be bound.
    void interpolate(const PixelRun& run, std::size_t numbers);
    void gather(const Chunk& chunk);

    std::shared_ptr<gl::Context> context_;
    DevicePixelImage& image_;
    gl::Program surface_;
    gl::Program interpolate_;
    Stage<std::size_t> compiling_;  // samples
    std::optional<gl::Program> count_;
    std::optional<gl::Program> list_;
    std::optional<gl::Program> gather_;
    std::optional<gl::Buffer> offsets_;  // of samples

    Stage<Version, Version> grouping_;  // geometry, visibility
    std::optional<gl::Buffer> groups_;  // of triangles: twice the surface, and 1 where a corner is occluded

    // Of the image in work.
    const PixelInput* input_ = nullptr;
    VertexBuffers* buffers_ = nullptr;

    Stage<int, int, int> sizing_;  // width, height, channels
    std::optional<gl::Buffer> list_of_points_;
    std::optional<gl::Buffer> weights_;
    std::optional<gl::Buffer> positions_;
    std::optional<gl::Buffer> normals_;
    std::optional<gl::Buffer> fractions_;
    std::vector<std::optional<gl::Buffer>> stokes_;
    std::optional<gl::Buffer> shares_;
    DevicePoints points_{};
    std::optional<DeviceLight> light_;
};

}  // namespace nicol
