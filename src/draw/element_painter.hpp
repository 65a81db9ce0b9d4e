// SPDX-License-Identifier: MIT
// draw: polarization elements before an image.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "draw/framebuffer.hpp"
#include "draw/vertex_buffers.hpp"
#include "draw/visibility_buffer.hpp"
#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "scene/scene.hpp"
#include "surfaces/refined_surfaces.hpp"

namespace nicol {

/// All members inside run() of the context.
class ElementPainter {
public:
    explicit ElementPainter(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Of the context's memory.
    static constexpr std::uint64_t kBytesPerElement = 80;

    /// Allocates what draw() needs. `projection`: of the world; the scene has elements. Throws
    /// Error(unsupported) for more vertices than the driver lets a shader reach.
    void prepare(const Scene& scene, const RefinedSurfaces& surfaces, const Projection& projection,
                 int samples, const Framebuffer& target);

    /// Each pixel's light becomes what the elements let through of it, the mean over its samples. `hits` show
    /// what the image shows, on the device; `buffers` are of the surfaces. Of the image, which must have all
    /// Stokes components, the first `components` stay.
    void draw(const VertexBuffers& buffers, const VisibilityBuffer& hits, int components,
              Framebuffer& target);

private:
    gl::Program& program(int channels, int samples);

    std::shared_ptr<gl::Context> context_;
    std::map<std::pair<int, int>, gl::Program> programs_;  // by channels that are drawn at once, samples
    std::optional<gl::Buffer> elements_;
    Projection projection_;  // of the surfaces' axes
};

}  // namespace nicol
