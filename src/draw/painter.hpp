// SPDX-License-Identifier: MIT
// Drawing of shaded vertices and the environment into a framebuffer.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "draw/aov_painter.hpp"
#include "draw/framebuffer.hpp"
#include "draw/pixel_image.hpp"
#include "draw/sample_pattern.hpp"
#include "draw/vertex_buffers.hpp"
#include "gl/draw.hpp"
#include "methods/executor.hpp"
#include "scene/projection.hpp"
#include "scene/scene.hpp"
#include "surfaces/refined_surfaces.hpp"

namespace nicol {

/// Painter of images, which keeps the textures of a scene's environment and the programs on the device.
class Painter {
public:
    explicit Painter(std::shared_ptr<gl::Context> context);

    struct Wanted {
        int components = 4;      ///< Stokes components that are drawn; the others are 0
        std::uint32_t aovs = 0;  ///< AOVs to draw, bits of AovBit
        std::span<const glm::dvec2> samples = sample_pattern(1);  ///< offsets of a pixel's samples
    };

    /// Image that a scene's surfaces are drawn into. `buffers` and `alpha_masks` must belong to `surfaces`;
    /// `projection` is of the world. If `pixels` is not null, it has made the image, and vertices are not
    /// drawn. in_memory: whether the image stays in its memory, so that AOVs alone are drawn.
    struct Subject {
        const Scene& scene;
        const RefinedSurfaces& surfaces;
        VertexBuffers& buffers;
        const AlphaMasks& alpha_masks;
        const RenderExecutor* pixels;
        bool in_memory;
        const Projection& projection;
    };

    /// Uploads and compiles what draw() with the same arguments needs, and does not touch the framebuffer's
    /// content, so that draw() is short. Several steps of the context; must be called outside run().
    void prepare(const Subject& subject, const Wanted& wanted, const Framebuffer& target);
    /// Draws an image, in several steps of the context. Must be called outside run(). With several samples,
    /// vertices are drawn once per sample and averaged, which gives every driver the same samples. All memory
    /// is allocated before the framebuffer is touched.
    void draw(const Subject& subject, const Wanted& wanted, Framebuffer& target);

private:
    // Channels that are drawn at once.
    struct Group {
        std::optional<gl::VertexArray> vertices;
        std::vector<gl::Texture2D> environment;  // one texture of all s0, or one Stokes texture per channel
    };

    gl::Program& program(const char* vertex, const char* fragment, int channels,
                         const std::set<std::string>& features);
    void bind_vertices(VertexBuffers& buffers, int channels);
    gl::Program& background_program(const Scene& scene, bool shaded, int channels);
    void compile(const Subject& subject, const Wanted& wanted, std::size_t group, int channels);
    void prepare_sample(bool several, const Framebuffer& target);
    // Draws everything but AOVs. All pixels of `target` are replaced.
    void draw_image(const Subject& subject, const Wanted& wanted, Framebuffer& target);
    void draw_samples(const Subject& subject, const Wanted& wanted, std::size_t group, int channels,
                      gl::RenderTarget& image);
    // Draws one sample of every pixel. projection: of the surfaces. most: triangles that are drawn of those
    // with one side, and with two.
    void draw_vertices(const Subject& subject, int components, const Projection& projection,
                       std::size_t group, int channels, std::size_t most, gl::RenderTarget& image);
    // projection: of the surfaces' axes.
    void draw_surface(const Subject& subject, int components, const Projection& projection, std::size_t group,
                      int channels, std::size_t most, gl::RenderTarget& image);
    // Adds the drawn sample to `image`, which becomes the mean of the samples.
    void add_sample(std::size_t sample, const Wanted& wanted, int channels, gl::RenderTarget& image);
    void upload_environment(const Environment& environment, int channels);
    // Draws the background behind the content of `image` or, if `shaded` is true, around its pixels.
    void draw_background(const Scene& scene, int components, const Projection& projection, bool shaded,
                         std::size_t group, int channels, gl::RenderTarget& image);

    std::shared_ptr<gl::Context> context_;
    std::map<std::tuple<std::string, int, std::set<std::string>>, gl::Program> programs_;
    std::set<std::tuple<int, int, bool, bool>> compiled_;  // channels, components, background, polarized
    std::vector<Group> groups_;
    Stage<Version, int> binding_;             // buffers, channels
    Stage<EnvironmentPtr, int> uploading_;    // environment, channels
    std::optional<gl::RenderTarget> sample_;  // one sample of every pixel; none: pixels have one sample
    PixelImage pixels_;
    AovPainter aovs_;
};

}  // namespace nicol
