// SPDX-License-Identifier: MIT
// Pipeline from a scene to its shaded vertices: project, bake, relight and shade. Each step runs again only
// if its inputs have changed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "draw/visibility_buffer.hpp"
#include "light/light_pyramid.hpp"
#include "methods/dense_method.hpp"
#include "methods/executor.hpp"
#include "methods/factored_method.hpp"
#include "methods/high_orders.hpp"
#include "render/image_hits.hpp"
#include "render/interpolation_error.hpp"
#include "render/light_projection.hpp"
#include "render/light_split.hpp"
#include "render/order_selector.hpp"
#include "render/predicted_error.hpp"
#include "render/scene_visibility.hpp"
#include "render/seen_triangles.hpp"
#include "render/shadow_error.hpp"
#include "scene/projection.hpp"
#include "scene/scene.hpp"
#include "shading/background.hpp"
#include "stage/options.hpp"
#include "surfaces/drawn_rays.hpp"
#include "surfaces/local_lights.hpp"
#include "surfaces/scene_geometry.hpp"
#include "surfaces/smooth_surfaces.hpp"
#include "surfaces/surface_rays.hpp"
#include "surfaces/vertex_stage.hpp"

namespace nicol {

class Pipeline {
public:
    /// Sets the cache folder of results that are slow to compute; an empty folder disables the cache.
    void set_cache(const std::filesystem::path& folder, const CacheNotice& notice);

    /// Takes over changes of the scene, and bakes what the images of some views of the world need: the first
    /// half of bake, on which the choice of orders depends. samples: as for needed_vertices().
    void bake(const Scene& scene, std::span<const Projection> views, std::span<const glm::dvec2> samples,
              const RenderOptions& options, RenderRun& run);
    /// Shades every vertex that can be seen, or every pixel that shows a surface. `executor` keeps the
    /// results. draw_hits: draws surfaces(). projection: of the world, one of the views of the last bake(),
    /// whose scene and options are those of this call. on_threads: whether the executor may make the image of
    /// shaded vertices, too. Adds times and counts to the statistics. After an exception, the next call
    /// computes everything that was not completed.
    void run(const Scene& scene, const Projection& projection, const RenderOptions& options,
             RenderExecutor& executor, RenderRun& run, const DrawHits& draw_hits, bool on_threads);

    /// Returns the surfaces that are drawn, in their own axes.
    [[nodiscard]] const RefinedSurfaces& surfaces() const noexcept { return visibility_.surfaces(); }
    /// Returns the hierarchy of surfaces(), for rays from pixels.
    [[nodiscard]] DrawnRays& drawn_rays() noexcept { return drawn_rays_; }
    /// Returns the number of vertices whose shadows the next run() improves.
    [[nodiscard]] std::size_t pending() const noexcept { return visibility_.pending(); }
    /// Returns whether the last run() shaded pixels.
    [[nodiscard]] bool shaded_pixels() const noexcept { return pixels_; }
    /// Returns whether the executor has made the image of the last run(). Otherwise its vertices are to be
    /// drawn.
    [[nodiscard]] bool made_image() const noexcept { return made_image_; }
    /// Returns whether the last run() took samples of lights, of lobes or at smooth surfaces.
    [[nodiscard]] bool sampled() const noexcept { return sampled_; }

private:
    [[nodiscard]] TransferMethod& method_for(Method method);
    /// Computes what the first render needs of lights and materials, for the most likely choices: beside the
    /// bake, much of which runs on one thread. sampled: terms that do not reflect harmonics.
    void project_ahead(const Scene& scene, SampledTerms sampled, const RenderOptions& options,
                       Statistics& statistics);
    /// Returns the options with the orders that their tolerance allows.
    RenderOptions choose_orders(const Scene& scene, const Projection& projection,
                                const RenderOptions& options, SampledTerms sampled, RenderRun& run);
    /// Returns whether rays follow smooth surfaces.
    [[nodiscard]] bool follows_smooth(const RenderOptions& options, const RenderExecutor& executor) const;
    /// Returns whether light becomes Stokes vectors at pixels. Otherwise, adds the error of shading at
    /// vertices to the predicted one.
    bool shades_pixels(const Scene& scene, const Projection& projection, const glm::dmat3& light_to_geometry,
                       const RenderOptions& options, const RenderExecutor& executor, Statistics& statistics);
    void shade(ShadeInput input, const Projection& projection, const RenderOptions& options,
               const DistantLight& distant, RenderExecutor& executor, RenderRun& run);
    /// Returns the input of images without high orders, local lights, smooth surfaces and bounced light.
    PixelInput pixel_input(const Scene& scene, const ShadeInput& input, const Projection& projection,
                           const RenderOptions& options, const RenderExecutor& executor,
                           const VisibilityBuffer& hits);
    void shade_pixels(const Scene& scene, ShadeInput input, const Projection& projection,
                      const RenderOptions& options, bool high_orders, RenderExecutor& executor,
                      RenderRun& run, const VisibilityBuffer& hits);
    /// Returns the predicted error of the chosen orders and of samples: the run's, or those of the last image
    /// if nothing was shaded.
    PredictedError predicted_error(const RenderRun& run, const Projection& projection);
    /// Returns 1 for each vertex that can be seen, else 0.
    std::span<const std::uint8_t> seen(const WorldGeometry& geometry, const Projection& projection,
                                       RenderRun& run);
    /// Sets chosen_ to 1 for each vertex that can be seen.
    void find_seen(const WorldGeometry& geometry, const Projection& projection, const RenderOptions& options,
                   RenderRun& run);
    /// Sets chosen_ to 1 for each vertex that can be seen and whose Stokes vector is not current.
    void choose_vertices(const WorldGeometry& geometry, const Projection& projection,
                         const RenderOptions& options, RenderRun& run);
    void count(const TransferInput& input, const DistantLight& distant, Statistics& statistics) const;

    InterpolationError interpolation_error_;  // first, because it is aligned for lanes
    SceneGeometry surfaces_;
    SurfaceRays rays_{surfaces_};
    SceneVisibility visibility_;
    LightSplit split_;
    KeptProjection projection_;  // of the light that remains after the split
    OrderSelector selector_;
    LightProjection light_;
    std::optional<LightLayout> direct_layout_;  // layout of the light that vertices keep
    FactoredMethod factored_;
    DenseMethod dense_;
    HighOrderTransfer high_orders_;
    LocalLights local_lights_;
    DrawnRays drawn_rays_;
    SmoothSurfaces smooth_;
    SeenTriangles seen_triangles_;
    ShadowError shadow_error_;
    PredictedError predicted_;  // of the chosen orders, of shadows and of shading at vertices
    LightingTally lighting_{};  // of the samples that the image holds
    LightingTally followed_{};  // of its rays that follow lobes
    SurfaceTally shown_s0_{};   // of its surfaces

    // Inputs: executor, method, view, light of low and high orders, rotation of the high orders, bounced
    // light, local lights, form of the high orders, with shadows, physical, noise, factors of the light,
    // channels, least and most components.
    VertexStage<Version, Method, Viewpoint, Version, Version, glm::dmat3, Version, Version, HighOrders, bool,
                bool, float, ChannelFactors, int, std::size_t, std::size_t>
        shading_{{.on_places = true, .on_materials = true}};
    // Inputs: geometry, projection to clip space, size of a pixel there.
    Stage<Version, glm::dmat4, glm::dvec2> seeing_;
    std::vector<std::uint8_t> seen_;   // find_visible() of these inputs
    std::vector<std::uint8_t> shown_;  // find_shown() of the last image that needed it
    std::size_t unseen_ = 0;           // number of its zeros
    std::vector<std::uint8_t> chosen_;

    std::optional<Background> background_;
    Stage<EnvironmentPtr, int, bool> showing_;  // environment, channels, whether the executor adds it
    std::optional<LightPyramid> sky_;           // environment that rays meet
    Stage<EnvironmentPtr> meeting_;
    bool projected_ahead_ = false;  // whether project_ahead() was called
    bool pixels_ = false;
    bool made_image_ = false;
    bool sampled_ = false;
    float noise_ = 0;  // noise for make_physical()
};

}  // namespace nicol
