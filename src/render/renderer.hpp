// SPDX-License-Identifier: MIT
// Renders one scene.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "devices/device.hpp"
#include "draw/element_painter.hpp"
#include "draw/painter.hpp"
#include "render/memory_estimate.hpp"
#include "render/pipeline.hpp"
#include "stage/options.hpp"

namespace nicol {

class Renderer {
public:
    /// threads = 0: one a core.
    Renderer(std::shared_ptr<gl::Context> context, int threads);

    /// See Pipeline::set_cache().
    void set_cache(const std::filesystem::path& folder, const CacheNotice& notice) {
        pipeline_.set_cache(folder, notice);
    }

    /// See MemoryLimit.
    void set_memory_limit(std::uint64_t bytes) { memory_limit_ = MemoryLimit(bytes); }

    /// The same scene every time. A framebuffer of one channel gets the luminance of a scene of three. Throws
    /// Error(invalid_argument) for options or a camera out of range, a framebuffer of another context or with
    /// channels that do not fit the scene; Error(unsupported) where compute shaders are requested and the
    /// driver lacks what they need, and where a material varies and vertices or the dense method are
    /// requested; Error(cancelled); Error(out_of_memory), also where the limit is exceeded. After an error
    /// the framebuffer is unchanged. Where nothing has changed since the last call, nothing is computed.
    void render(const Scene& scene, const Camera& camera, const RenderOptions& options, Framebuffer& target);

private:
    // Into a framebuffer of the scene's channels, by the reference method also of their luminance.
    void render_into(const Scene& scene, const Camera& camera, const RenderOptions& options,
                     Framebuffer& target);
    void draw(const Scene& scene, const Projection& projection, const RenderOptions& options,
              Framebuffer& target);
    // As many images as the options have samples of a pixel, and their mean.
    void draw_one_by_one(const Scene& scene, const Projection& projection, const RenderOptions& options,
                         Framebuffer& target);
    // Copies surfaces to the device, inside run() of the context.
    void update_buffers(const RefinedSurfaces& surfaces, int channels);
    [[nodiscard]] RenderExecutor& executor_for(const RenderOptions& options);

    std::shared_ptr<gl::Context> context_;
    int threads_;
    MemoryLimit memory_limit_;
    std::unique_ptr<Framebuffer> colours_;  // of three channels, for drawing where the target is of luminance
    Workers workers_;
    Pipeline pipeline_;
    VertexBuffers buffers_;
    AlphaMasks alpha_masks_;
    VisibilityBuffer hits_;
    const Device* device_ = nullptr;  // of the executor
    std::unique_ptr<RenderExecutor> executor_;
    Painter painter_;
    ElementPainter elements_;

    // What the last image was made of: versions of the scene, camera, options.
    Stage<Version, Version, Version, Version, Version, Version, Camera, RenderOptions> rendering_;
    Version content_ = 0;  // of the framebuffer that has it
};

}  // namespace nicol
