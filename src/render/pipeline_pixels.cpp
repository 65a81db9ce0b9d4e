// SPDX-License-Identifier: MIT
// Images that an executor makes from hits.
#include <algorithm>

#include "render/pipeline.hpp"
#include "surfaces/photon_paths.hpp"

namespace nicol {
namespace {

// Returns the largest number of events at smooth surfaces. The last segment of a path, from the last event to
// a light, is the environment's or that of the light which surfaces reflect.
int smooth_events(int max_depth) {
    // Direct light is the default, which does not say how often glass is passed.
    constexpr int of_direct_light = 8;
    return max_depth == kDirectLightDepth ? of_direct_light : std::min(max_depth - 1, kMostSmoothEvents);
}

}  // namespace

PixelInput Pipeline::pixel_input(const Scene& scene, const ShadeInput& input, const Projection& projection,
                                 const RenderOptions& options, const RenderExecutor& executor,
                                 const VisibilityBuffer& hits) {
    const bool behind = scene.background() != nullptr && executor.adds_background();
    showing_.run(scene.background(), input.channels, behind, [&] {
        background_.reset();
        if (behind) background_.emplace(*scene.background(), input.channels);
    });
    PixelInput out{input, projection, hits};
    out.physical = options.physical;
    out.seed = static_cast<std::uint32_t>(options.seed);
    if (behind) out.background = &*background_;
    out.light_scale = scene.light_scale();
    return out;
}

void Pipeline::shade_pixels(const Scene& scene, ShadeInput input, const Projection& projection,
                            const RenderOptions& options, bool high_orders, RenderExecutor& executor,
                            RenderRun& run, const VisibilityBuffer& hits) {
    const Stopwatch watch;
    shading_.reset();  // the vertices' results then belong to another render
    chosen_.assign(input.geometry.positions.size(), 1);
    if (input.seen) std::ranges::copy(input.seen(), chosen_.begin());
    input.chosen = chosen_;
    const bool smooth = follows_smooth(options, executor);
    const EnvironmentPtr met = smooth ? scene.distant_light() : nullptr;
    meeting_.run(met, [&] {
        if (met)
            sky_.emplace(*met);
        else
            sky_.reset();
    });
    PixelInput pixels = pixel_input(scene, input, projection, options, executor, hits);
    if (high_orders) pixels.high_orders = &high_orders_;
    if (local_lights_.any()) pixels.local_lights = &local_lights_;
    if (smooth) pixels.smooth = &smooth_;
    pixels.smooth_events = smooth_events(options.max_depth);
    if (met) pixels.sky = &*sky_;
    if (input.bounces > 0) pixels.bounced = &factored_.bounces();
    method_for(options.method).shade_pixels(pixels, executor, run);
    executor.finish();
    run.statistics.shade_ms += watch.milliseconds();
}

}  // namespace nicol
