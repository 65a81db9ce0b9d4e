// SPDX-License-Identifier: MIT
// Drawing of polarization elements in front of an image.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "draw/framebuffer.hpp"
#include "draw/vertex_buffers.hpp"
#include "draw/visibility_buffer.hpp"
#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "scene/scene.hpp"
#include "surfaces/refined_surfaces.hpp"
#include "versioned.hpp"

namespace nicol {

/// Words of the textures of an element in glsl/texture.glsl's table.
struct ElementWords {
    std::uint32_t angle, retardance;
};

/// Painter of polarization elements. All members must be called inside run() of the context.
class ElementPainter {
public:
    explicit ElementPainter(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Returns the bytes of the context's memory for the elements of a scene.
    [[nodiscard]] static std::uint64_t bytes(const Scene& scene);

    /// Allocates everything that draw() needs. The scene must have elements. projection: of the world. Throws
    /// Error(unsupported) for more vertices, or texels of elements, than the driver lets a shader reach.
    void prepare(const Scene& scene, const RefinedSurfaces& surfaces, const Projection& projection,
                 int samples, const Framebuffer& target);

    /// Replaces each pixel's light by the light that the elements transmit, the mean over the pixel's
    /// samples. hits: visibility buffer of the image, on the device. buffers: of the surfaces. The image must
    /// have all Stokes components; its first `components` are kept.
    void draw(const VertexBuffers& buffers, const VisibilityBuffer& hits, int components,
              Framebuffer& target);

private:
    void prepare_textures(const std::vector<ElementTextures>& of_elements);
    gl::Program& program(int channels, int samples);

    std::shared_ptr<gl::Context> context_;
    // By number of channels that are drawn at once, of samples, and by whether there are textures.
    std::map<std::tuple<int, int, bool>, gl::Program> programs_;
    std::optional<gl::Buffer> elements_;
    Stage<std::vector<ElementTextures>> textures_stage_;  // keeps them, so that no other has their address
    std::vector<ElementWords> words_;                     // of each element
    std::optional<gl::Buffer> texture_table_, texels_;    // empty: there are no textures
    Projection projection_;                               // projection of the surfaces' axes
};

}  // namespace nicol
