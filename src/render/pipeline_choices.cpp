// SPDX-License-Identifier: MIT
// Choices of a render: orders, and whether pixels are shaded.
#include <cmath>
#include <glm/matrix.hpp>

#include "render/pipeline.hpp"
#include "scene/path_depth.hpp"

namespace nicol {
namespace {

// Returns whether orders are chosen by the predicted error of those that are left out.
bool predicts_orders(const RenderOptions& options) {
    return options.method == Method::factored && options.high_orders != HighOrders::convolution &&
           options.choose_orders && options.tolerance > 0;
}

}  // namespace

void Pipeline::project_ahead(const Scene& scene, SampledTerms sampled, const RenderOptions& options,
                             Statistics& statistics) {
    if (scene.distant_light() == nullptr) return;
    split_.update(scene.distant_light(), options, statistics);
    // Lobes that samples reflect depend on the image if it has several samples, and on whether rays follow
    // glass.
    if (options.pixel_samples > 1 || scene.transmits()) return;
    if (predicts_orders(options)) selector_.prepare(scene, {split_.rest(), sampled}, projection_);
    // Bounces mostly put shading at pixels.
    if (options.shade_at != ShadeAt::pixels && options.max_depth <= kDirectLightDepth && !scene.varies() &&
        scene.lights().empty() && split_.extracted_lights().empty())
        interpolation_error_.prepare(scene, split_.rest());
}

bool Pipeline::shades_pixels(const Scene& scene, const Projection& projection,
                             const glm::dmat3& light_to_geometry, const RenderOptions& options,
                             const RenderExecutor& executor, Statistics& statistics) {
    if (options.shade_at == ShadeAt::pixels) return true;
    const bool automatic = options.shade_at == ShadeAt::automatic;
    if (automatic && ((options.pixel_samples > 1 && executor.samples_pixels()) || scene.varies() ||
                      local_lights_.any() || follows_smooth(options, executor)))
        return true;
    const double error =
        interpolation_error_.of(visibility_.state().geometry, seen_triangles_.update(visibility_.state()),
                                projection, split_.rest(), glm::transpose(light_to_geometry));
    if (automatic && error > options.tolerance) return true;
    predicted_.add_relative(error);
    statistics.interpolation_error = error;
    return false;
}

RenderOptions Pipeline::choose_orders(const Scene& scene, const Projection& projection,
                                      const RenderOptions& options, SampledTerms sampled, RenderRun& run) {
    // Error of dark places, where polarization must be distinguished from noise, relative to the error of the
    // image.
    constexpr double of_dark = 1.0 / 3;
    RenderOptions chosen = options;
    predicted_ = {};
    noise_ = 0;
    if (scene.distant_light() == nullptr) {  // the reflection of local lights has no orders
        chosen.order_low = chosen.order_high = 0;
        return chosen;
    }
    ShadowError::Seen seen;
    run.workers.run([&] {
        seen = shadow_error_.of(visibility_.state(), visibility_.pending() == 0,
                                seen_triangles_.update(visibility_.state()), projection);
    });
    run.statistics.shadow_error = seen.error;
    predicted_.add_relative(seen.error);
    if (!predicts_orders(options)) return chosen;
    const Stopwatch watch;
    RenderOptions of_orders = options;
    of_orders.tolerance = left_of_tolerance(options.tolerance, shadow_error_.of_all());
    run.workers.run([&] {
        const OrderSelector::Orders orders = selector_.choose(
            scene, {split_.rest(), sampled}, visibility_.state(),
            visibility_.pending() == 0 && !visibility_.grew(), of_orders, run.memory_limit, projection_);
        chosen.order_low = orders.low;
        chosen.order_high = orders.high;
        run.statistics.order_error = orders.error;
        const double rms = orders.rms * scene.light_scale();
        const double error = orders.error * rms;
        predicted_.add(std::pow(kErrorOfOrders * error, 2), rms * rms * seen.brightness);
        const double noise = of_dark * error;
        // Rounded to steps, so that the noise stays the same when an object moves.
        if (noise > 0) noise_ = static_cast<float>(std::exp2(std::round(2 * std::log2(noise)) / 2));
    });
    run.statistics.project_ms += watch.milliseconds();
    return chosen;
}

}  // namespace nicol
