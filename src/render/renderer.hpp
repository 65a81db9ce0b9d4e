// SPDX-License-Identifier: MIT
// Renderer of one scene.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "devices/device.hpp"
#include "draw/drawn_hits.hpp"
#include "draw/element_painter.hpp"
#include "draw/painter.hpp"
#include "draw/traced_hits.hpp"
#include "render/memory_estimate.hpp"
#include "render/pipeline.hpp"
#include "render/time_budget.hpp"
#include "stage/options.hpp"
#include "texture/texture.hpp"
#include "worker_pool.hpp"

namespace nicol {

/// An image to render: a camera, and the framebuffer that receives the image.
struct View {
    Camera camera;
    Framebuffer* target;
};

/// Gradients of a picture to compute.
struct WantedGradients {
    bool environment = false;
    bool lights = false;
    bool instances = false;
    TexturePtr texture = nullptr;  ///< texture of whose texels the gradient is wanted; null: of none
};

/// Gradients of a function of a picture.
struct Gradients {
    /// By the coefficients of the environment up to order_low, in all channels of the scene.
    PshVector environment;
    /// By the Stokes vectors of the local lights, in the frames of their axes, [light][channel][component].
    std::vector<double> lights;
    /// By a factor of what each instance reflects, [instance][channel].
    std::vector<double> instances;
    /// By the texels of a texture, [row][column][channel].
    std::vector<double> texels;
};

class Renderer {
public:
    explicit Renderer(std::shared_ptr<gl::Context> context, WorkerOptions workers = {});

    /// Sets the cache folder, see Pipeline::set_cache().
    void set_cache(const std::filesystem::path& folder, const CacheNotice& notice) {
        pipeline_.set_cache(folder, notice);
    }

    /// Sets the limit of the memory, and who is told of it.
    void set_memory_limit(MemoryLimit limit) { memory_limit_ = std::move(limit); }

    /// Renders the scene, which must be the same in all calls. A framebuffer of one channel gets the
    /// luminance of a scene of three. Throws Error(invalid_argument) for options or a camera out of range,
    /// and for a framebuffer of another context or with channels that do not fit the scene;
    /// Error(unsupported) if compute shaders are requested and the driver lacks features, and if a material
    /// is textured and vertices or the dense method are requested; Error(cancelled); Error(out_of_memory),
    /// also if the limit is exceeded. After an error the framebuffer is unchanged. If nothing has changed
    /// since the last call, nothing is computed. Locks the framebuffer only to put the image into it. Returns
    /// the framebuffer's statistics.
    Statistics render(const Scene& scene, const Camera& camera, const RenderOptions& options,
                      Framebuffer& target);
    /// Renders images of some views, at least one, one after the other. The first of them that is drawn bakes
    /// what all of them need. Invalid arguments are refused before any of them is rendered; after another
    /// error, the framebuffers of the views before it have their images.
    std::vector<Statistics> render(const Scene& scene, std::span<const View> views,
                                   const RenderOptions& options);

    /// Computes gradients from the gradient of the picture that render() makes. picture: by the Stokes
    /// vectors of the pixels, in all channels of the scene. Throws what render() throws;
    /// Error(invalid_argument) for a picture of other channels, and if gradients by what the scene does not
    /// have are wanted; Error(unsupported) for a picture that is not linear in its light, or that
    /// AdjointExecutor refuses.
    Gradients adjoint(const Scene& scene, const Camera& camera, const RenderOptions& options,
                      const StokesImage& picture, const WantedGradients& wanted);

private:
    // Size of an image.
    struct ImageShape {
        int width, height, channels;
    };
    // Bake of the views of one call.
    struct CommonBake {
        std::vector<Projection> views;
        bool done = false;
    };

    // Renders into a framebuffer of the scene's channels or, with the reference method, of their luminance.
    Statistics render_into(const Scene& scene, const Camera& camera, const RenderOptions& options,
                           Framebuffer& target, CommonBake& common);
    // Renders the luminance of a scene of three channels.
    Statistics render_grey(const Scene& scene, const Camera& camera, const RenderOptions& options,
                           Framebuffer& target, CommonBake& common);
    // Bakes unless it is done. Returns the work.
    RenderWork bake(const Scene& scene, const RenderOptions& options, CommonBake& common);
    // Draws with what the options' time budget affords.
    void draw_within_budget(const Scene& scene, const Projection& projection, const RenderOptions& options,
                            Framebuffer& target);
    // Returns a framebuffer of the size and channels of `target` that nobody else uses.
    [[nodiscard]] Framebuffer& spare_of(const Framebuffer& target);
    // Locks the framebuffer, calls `draw`, which replaces the content, and remembers what the content is.
    void put(Framebuffer& target, const std::function<void()>& draw);
    void put(Framebuffer& target, StokesImage image, const Statistics& statistics, Aovs aovs);
    // Traces an image by the reference method.
    void trace(const Scene& scene, const Projection& projection, const RenderOptions& options,
               Framebuffer& target);
    void draw(const Scene& scene, const Projection& projection, const RenderOptions& options,
              Framebuffer& target);
    // Draws as many images as the options have samples per pixel, and averages the images.
    void draw_one_by_one(const Scene& scene, const Projection& projection, const RenderOptions& options,
                         Framebuffer& target);
    // Finds the hits of the pipeline's surfaces, by rays if they are expected to cost less.
    void find_hits(const Projection& projection, const RenderOptions& options, VisibilityBuffer::Kept kept,
                   const ImageShape& image, Statistics& statistics);
    // Frees the memory of hits.
    void clear_hits();
    // Copies surfaces to the device, if they changed.
    void update_buffers(const RefinedSurfaces& surfaces, int channels);
    [[nodiscard]] RenderExecutor& executor_for(const Scene& scene, const RenderOptions& options);

    Pipeline pipeline_;
    std::shared_ptr<gl::Context> context_;
    WorkerOptions worker_options_;
    MemoryLimit memory_limit_;
    std::unique_ptr<Framebuffer> colours_;  // framebuffer of three channels, for a target of luminance
    std::unique_ptr<Framebuffer> spare_;    // framebuffer to draw into while others read the target
    Workers workers_;
    TimeBudget budget_;
    VertexBuffers buffers_;
    AlphaMasks alpha_masks_;
    // Inputs of buffers_ and alpha_masks_: geometry, materials, channels. A frame that uploads nothing does
    // not wait for the thread of OpenGL.
    Stage<Version, Version, int> uploading_;
    VisibilityBuffer hits_;
    DrawnHits drawn_hits_;
    TracedHits traced_hits_;
    // Inputs of hits_: geometry, projection to clip space, samples of a pixel, size of the image, location of
    // the hits, whether rays find them.
    Stage<Version, glm::dmat4, int, std::pair<int, int>, VisibilityBuffer::Kept, bool> finding_;
    const Device* device_ = nullptr;  // device of the executor
    std::unique_ptr<RenderExecutor> executor_;
    Painter painter_;
    ElementPainter elements_;

    // Inputs of the last image: versions of the scene, camera, options.
    Stage<Version, Version, Version, Version, Version, Version, Camera, RenderOptions> rendering_;
    std::pair<std::uint64_t, int> sampling_;  // seed and light_samples of the last real-time image
    Version content_ = 0;                     // content() of the framebuffer with the last image
};

}  // namespace nicol
