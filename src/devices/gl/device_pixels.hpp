// SPDX-License-Identifier: MIT
// Shading at pixels on the device: the points that pixels show are shaded like vertices.
#pragma once

#include <algorithm>
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

/// List of the points that an image's pixels show, and the image made from them. The points equal those that
/// SurfaceShading finds on threads. Points are listed for some pixels at a time. The points of a group are
/// consecutive; a group has the points of one range of the geometry, either with or without an occluded
/// corner. Only the numbers of points come back to the host. All members must be called inside run() of the
/// context.
class DevicePixelList {
public:
    explicit DevicePixelList(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Pixels whose points are listed together.
    struct Chunk {
        std::size_t first;
        std::size_t last;
        /// First point of each group in the list, a multiple of gl::kGroupOfVertices. A group's index is
        /// that of its range, plus the number of ranges if a corner is occluded.
        std::vector<std::uint32_t> begin;
        std::vector<std::uint32_t> counts;  ///< number of points of each group
        std::size_t size;                   ///< length of the list
    };

    /// Counts the points of an image and writes its coverage. Returns the image's chunks. The arguments must
    /// live until the last gather().
    [[nodiscard]] std::vector<Chunk> find(const PixelInput& input, VertexBuffers& buffers,
                                          DevicePixelImage& image);
    /// Makes the list of a chunk's points.
    void list(const Chunk& chunk);
    /// Returns the listed points in the layout of glsl/pixel_points.glsl.
    [[nodiscard]] const gl::Buffer& points() const { return points_.value(); }
    /// Makes a chunk's pixels. stokes: Stokes vectors of the chunk's points. local_lights, if the input has
    /// any: Stokes vectors that they add to each pixel, by channel.
    void gather(const Chunk& chunk, const StokesBuffer& stokes,
                std::span<const std::vector<glm::vec4>> local_lights);
    /// Frees the memory of the last list.
    void release();

private:
    void compile(std::span<const glm::dvec2> offsets, bool lit);
    void upload(std::span<const std::vector<glm::vec4>> local_lights, std::size_t pixels);
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
    std::optional<gl::Buffer> offsets_;  // offsets of the samples
    Stage<Version, Version> grouping_;   // geometry, visibility
    std::optional<gl::Buffer> groups_;   // groups of the triangles
    std::optional<gl::Buffer> counts_;
    std::optional<gl::Buffer> places_;
    std::optional<gl::Buffer> points_;
    std::optional<gl::Buffer> shares_;
    std::optional<StokesBuffer> lights_;  // local lights of a chunk's pixels
};

/// Consecutive points of one surface.
struct PixelRun {
    const VertexRange& surface;
    bool occluded;      ///< false: nothing hides the light from the corners of the points' triangles
    std::size_t first;  ///< index of the first point, a multiple of gl::kGroupOfVertices
    std::size_t last;
};

/// Runs whose light is computed together: those that are not occluded, then those that are.
struct PixelStretch {
    std::vector<PixelRun> runs;  ///< ascending, at least one; points between them have any values

    [[nodiscard]] std::size_t first() const { return runs.front().first; }
    [[nodiscard]] std::size_t last() const { return runs.back().last; }
    /// Returns the first occluded point; last() if there is none.
    [[nodiscard]] std::size_t occluded() const {
        const auto found = std::ranges::find(runs, true, &PixelRun::occluded);
        return found != runs.end() ? found->first : last();
    }
};

/// Shading of the points that pixels show. All members must be called inside run() of the context.
class DevicePixels {
public:
    /// image: must outlive the object, and have an image's size before the image is shaded.
    DevicePixels(std::shared_ptr<gl::Context> context, DevicePixelImage& image);

    /// Runs that make a stretch together: none, or those of plain materials.
    enum class Joins { none, plain };
    using Shade = std::function<void(const PixelStretch&)>;
    using Finish = std::function<void(std::size_t last)>;
    /// Calls shade(stretch) until all points are shaded, at most `most` points at once, then finish(last) for
    /// points i < last, which may be more than were shaded. shade() must fill points().stokes. The image is
    /// made from these Stokes vectors, and local lights are added to it.
    /// Returns the number of points. Throws Error(unsupported) for more triangles or vertices than the driver
    /// lets a shader reach.
    std::uint64_t run(const PixelInput& input, VertexBuffers& buffers, std::size_t most, Joins joins,
                      RenderRun& render, const Shade& shade, const Finish& finish);

    /// Returns the points while shade() runs.
    [[nodiscard]] const DevicePoints& points() const noexcept { return points_; }
    /// Returns the points in the layout of glsl/pixel_points.glsl while shade() runs.
    [[nodiscard]] const gl::Buffer& listed() const { return list_.points(); }
    /// Returns one vec2 per point: the weights of the second and third corner of the point's triangle.
    [[nodiscard]] const gl::Buffer& barycentric() const { return weights_.value(); }
    /// Returns memory for the light of points first <= i < last, valid until the next call. coefficients:
    /// number per point and channel.
    [[nodiscard]] DeviceLight& light(std::size_t first, std::size_t last, std::size_t coefficients,
                                     int channels);
    /// Returns the light of the last call.
    [[nodiscard]] const DeviceLight& light() const { return light_.value(); }
    /// Interpolates the light of vertices at the points of `light` from `first` on, a multiple of
    /// gl::kGroupOfVertices. The vertices of the points' triangles may lie in several lights; `light` is
    /// complete after calls for all of them. add: whether to add to what an earlier call found.
    void interpolate(const DeviceLight& vertices, bool add, std::size_t first, DeviceLight& light);

private:
    void release();
    void make_room_for(std::size_t points);
    /// Finds the surfaces at the listed points.
    void find_surfaces(std::size_t points);
    void interpolate_fractions(std::size_t points);
    // Expects source and result to be bound.
    void interpolate(gl::Program& program, std::size_t first, std::size_t last, std::size_t coefficients,
                     int channels);

    std::shared_ptr<gl::Context> context_;
    DevicePixelImage& image_;
    DevicePixelList list_;
    gl::Program surface_;
    gl::Program interpolate_light_;
    gl::Program interpolate_fractions_;

    // Input of the image that is being shaded.
    const PixelInput* input_ = nullptr;
    VertexBuffers* buffers_ = nullptr;

    Stage<std::size_t, std::size_t, int> sizing_;  // width, height, channels
    std::optional<gl::Buffer> weights_;
    std::optional<gl::Buffer> positions_;
    std::optional<gl::Buffer> normals_;
    std::optional<gl::Buffer> fractions_;
    std::optional<StokesBuffer> stokes_;
    DevicePoints points_{};
    std::optional<DeviceLight> light_;
};

}  // namespace nicol
