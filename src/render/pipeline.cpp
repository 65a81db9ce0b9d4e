// SPDX-License-Identifier: MIT
#include "render/pipeline.hpp"

#include <tbb/task_group.h>

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <utility>
#include <vector>

#include "polarization/viewpoint.hpp"
#include "render/grazing_lobes.hpp"
#include "render/needed_vertices.hpp"
#include "render/sampled_lobes.hpp"
#include "render/wanted_executor.hpp"
#include "surfaces/geometry.hpp"
#include "surfaces/rigid_motion.hpp"

namespace nicol {
namespace {

// Share of the tolerance, as its inverse, that bounces may leave out.
constexpr double kBouncesOfTolerance = 4;

// Returns whether surfaces light each other. That needs the bake whatever the light, because light bounces
// where surfaces hide others.
bool light_bounces(const RenderOptions& options) {
    return options.max_depth > kDirectLightDepth;
}

// Returns whether the bake finds out what light reaches. An instance that receives no shadows needs it for
// local lights, because rays are spared where nothing is occluded.
bool needs_bake(const Scene& scene, const RenderOptions& options) {
    return scene.distant_light() != nullptr || light_bounces(options) ||
           std::ranges::any_of(scene.instances(),
                               [](const Instance& instance) { return !instance.roles.receives_shadows; });
}

// Returns whether rays are followed from pixels that show smooth surfaces.
bool follows_rays(Method method, const RenderExecutor& executor) {
    return method == Method::factored && executor.follows_rays();
}

// Returns whether vertices that an image does not show may be left out.
bool skips_hidden(const RenderOptions& options) {
    return options.method == Method::factored && (options.disabled_optimisations & skip_hidden) == 0;
}

ImageNeeds needs_of(const RenderOptions& options) {
    // Bounced light depends on all shadows, whether pixels resolve them or not.
    const bool all =
        !skips_hidden(options) || (options.disabled_optimisations & skip_rays) != 0 || light_bounces(options);
    return all ? ImageNeeds::all : ImageNeeds::seen;
}

// The last digits of the threads' sums depend on who adds what.
double rounded(double sum) {
    return static_cast<double>(static_cast<float>(sum));
}

}  // namespace

void Pipeline::set_cache(const std::filesystem::path& folder, const CacheNotice& notice) {
    visibility_.set_cache(folder, notice);
    factored_.set_cache(folder, notice);
    high_orders_.set_cache(folder, notice);
}

void Pipeline::bake(const Scene& scene, std::span<const Projection> views,
                    std::span<const glm::dvec2> samples, const RenderOptions& options, RenderRun& run) {
    surfaces_.update(scene);
    std::vector<Projection> of_surfaces;
    for (const Projection& view : views) of_surfaces.push_back(in_axes(view, surfaces_.to_world()));
    tbb::task_group beside;
    if (!std::exchange(projected_ahead_, true))
        beside.run([&] {
            project_ahead(scene, sampled_terms(scene, options, false, true), options, run.statistics);
        });
    try {
        visibility_.update(surfaces_, rays_, needs_bake(scene, options),
                           {.needs = needs_of(options),
                            .views = of_surfaces,
                            .samples = samples,
                            .lobes = wants_lobes(options)},
                           options, run.workers, run.progress, run.statistics);
    } catch (...) {
        // An exception would cancel the group, whose loops then end early and leave sums of a part.
        beside.wait();
        throw;
    }
    beside.wait();
}

void Pipeline::run(const Scene& scene, const Projection& of_world, const RenderOptions& given,
                   RenderExecutor& executor, RenderRun& run, const DrawHits& draw_hits, bool on_threads) {
    TransferMethod& method = method_for(given.method);
    const bool bouncing = light_bounces(given);
    const Projection projection = in_axes(of_world, surfaces_.to_world());
    ImageHits hits(draw_hits, shown_, run);
    visibility_.bake_shown(
        surfaces_, rays_, [&] { return hits.shown(visibility_.surfaces().geometry()); }, wants_lobes(given),
        given, run);
    visibility_.count(surfaces_, run.statistics);
    const SurfaceState surfaces = visibility_.state();

    // project: a rotation of the whole scene is the opposite rotation of light and camera.
    split_.update(scene.distant_light(), given, run.statistics);
    const bool follows_rays = nicol::follows_rays(given.method, executor);
    SampledTerms sampled = sampled_terms(scene, given, follows_rays, surfaces.visibility != nullptr);
    // Samples cost more than orders when the light rotates, so that images of one sample take none of these.
    if (sampled.kind == SampledTerms::anisotropic_narrow && given.choose_orders && given.tolerance > 0 &&
        given.pixel_samples > 1 && executor.samples_pixels() &&
        scene.distant_light()->pixels().values != nullptr)
        sampled.narrowest =
            std::max(sampled.narrowest,
                     narrowest_in_harmonics(surfaces.geometry, seen_triangles_.update(surfaces), projection));
    RenderOptions options = choose_orders(scene, projection, given, sampled, run);
    const int bounces = bouncing && surfaces.visibility != nullptr ? given.max_depth - kDirectLightDepth : 0;
    const bool has_distant = scene.distant_light() != nullptr;
    LeastLight least;
    if (bounces > 0) {
        least = {.kind = given.components > 1 ? LightKind::linear : LightKind::unpolarized,
                 .channels = scene.channels()};
        options.order_low = order_with_bounces(options.order_low, has_distant, given.choose_orders);
        options.order_high = std::max(options.order_high, options.order_low);
    }
    const glm::dmat3 light_to_geometry =
        glm::transpose(glm::dmat3(surfaces_.to_world())) * scene.light_rotation();
    // Bounced light is the sum of what bounces of several lights, so no factor remains for the distant one.
    light_.update(split_.rest(), scene.light_scale(), bounces > 0, options, least, light_to_geometry,
                  projection_, run.statistics);
    // Local lights need no shadow rays if the bake found that nothing is occluded. Clear glass stops none of
    // its rays.
    RenderOptions lighting = options;
    if (needs_bake(scene, given) && surfaces.visibility == nullptr && !scene.transmits())
        lighting.shadows = false;
    // Lobes reflect no other surface if nothing hides anything.
    const bool follows_lobes = follows_rays && bounces > 0 && wants_lobes(options);
    if (follows_rays) smooth_.update(visibility_.surfaces(), drawn_rays_, follows_lobes);
    local_lights_.update(
        scene, {split_.extracted_lights(), scene.distant_light(), split_.rest(), sampled, light_to_geometry},
        visibility_.surfaces(), rays_, {follows_rays && options.shadows ? &smooth_ : nullptr, bounces},
        lighting, run);
    rays_.release();
    sampled_ = local_lights_.any() || follows_smooth(options, executor);
    // Only low orders bounce, so their polarization says nothing of the light's high orders.
    const bool polarized = (options.disabled_optimisations & skip_light_components) != 0 ||
                           light_kind(split_.rest().get()) != LightKind::unpolarized;
    // The layout below differs between vertices and pixels, and a change of it bakes all vertices anew, so
    // that no camera may cause one.
    RenderOptions placed = options;
    if (bounces > 0 && follows_rays && !polarized && options.shade_at == ShadeAt::automatic)
        placed.shade_at = ShadeAt::pixels;
    pixels_ = shades_pixels(scene, projection, light_to_geometry, placed, executor, run.statistics);
    // If bounces alone are polarized, they stay apart: direct light then needs no orders of s1 and s2.
    const bool apart =
        bounces > 0 && pixels_ && follows_rays && (smooth_.any() ? smooth_.mirrors() : !polarized);
    // If bounces stay apart, local lights alone leave no orders to direct light.
    direct_layout_.emplace(apart && !has_distant ? 0 : light_.layout().order(),
                           apart && !polarized ? LightKind::unpolarized : light_.layout().kind());
    TransferInput input{
        surfaces,
        *direct_layout_,
        *light_.rotated(),
        light_.rotated().version(),
        scene.channels(),
        sampled,
        pixels_,
        follows_lobes,
        apart,
        bounces,
        std::min(highest_bounce_order(has_distant), options.order_low),
        light_.layout().kind(),
        options.tolerance / kBouncesOfTolerance,
        local_lights_.any() ? &local_lights_ : nullptr,
        (options.disabled_optimisations & skip_response_rows) != 0 ? std::size_t{4} : std::size_t{1},
        static_cast<std::size_t>(options.components)};
    if (local_lights_.any()) hits.keep_on_host();
    const auto shown = [&] {
        return pixels_ ? hits.shown(surfaces.geometry) : seen(surfaces.geometry, projection, run);
    };
    if (skips_hidden(given) && executor.can_choose() &&
        (!follows_smooth(given, executor) || !shows_others(surfaces.geometry, shown(), wants_lobes(given))))
        input.seen = shown;
    const DistantLight distant{.coefficients = *light_.distant(),
                               .version = light_.distant().version(),
                               .low = options.order_low,
                               .high = light_.last_order(),
                               .polarized = polarized};
    const bool high_orders = distant.high > distant.low;
    method.project(input, run);
    if (high_orders) high_orders_.project(input, distant, options.high_orders, run);

    // Second half of bake.
    const double before = run.statistics.bake_ms;
    TransferInput high_input = input;
    if (!options.high_order_shadows) {
        high_input.visibility = nullptr;
        high_input.versions.visibility = 0;
        high_input.change.reset();
    }
    std::optional<VisibilityRequest> request;
    if (high_orders) request = high_orders_.request(high_input, distant.low, run);
    method.bake(input, request ? &*request : nullptr, run);
    if (high_orders) high_orders_.bake(high_input, distant.low, std::move(request), run);

    method.relight(input, executor, run);
    visibility_.count_later_steps(run.statistics.bake_ms - before + run.statistics.relight_ms);

    const ShadeInput shaded{input, projection.view, {}, light_to_geometry, light_.factors(), noise_};
    made_image_ = pixels_;
    if (pixels_) {
        shade_pixels(scene, shaded, projection, options, high_orders, executor, run, hits.get());
    } else {
        shade(shaded, projection, options, distant, executor, run);
        if (on_threads && executor.interpolates()) {
            made_image_ = true;
            const VisibilityBuffer& shown = hits.get();
            const Stopwatch watch;
            executor.interpolate(pixel_input(scene, shaded, projection, options, executor, shown), run);
            run.statistics.draw_ms += watch.milliseconds();
        }
    }

    method.count(input, run.statistics);
    run.statistics.bounce_error =
        std::hypot(error_of_bounces(run.statistics.bounced_light), run.statistics.bounced_left);
    PredictedError predicted = predicted_error(run, projection);
    predicted.add_relative(run.statistics.bounce_error);
    run.statistics.predicted_error = predicted.relative();
    executor.count(run.statistics);
    count(input, distant, run.statistics);
}

PredictedError Pipeline::predicted_error(const RenderRun& run, const Projection& projection) {
    if (!local_lights_.any()) lighting_ = {};
    // No pixel's own values are lit if all light of surfaces comes through glass.
    if (run.lighting.values > 0 || run.surfaces.covered > 0) lighting_ = run.lighting;
    if (run.statistics.pixels_shaded + run.statistics.vertices_shaded > 0) {
        followed_ = run.followed;
        shown_s0_ = run.surfaces;
    }
    PredictedError out = predicted_;
    // An image that is one of many samples of its pixels has their mean's noise.
    const double share = projection.sample_size * projection.sample_size;
    for (const LightingTally* const sampled : {&lighting_, &followed_}) {
        const double shown = shown_s0_.covered > 0 ? shown_s0_.covered : sampled->values;
        if (shown == 0) continue;
        out.add_noise(rounded(share * sampled->noise / shown), rounded(sampled->power / shown));
    }
    if (shown_s0_.whole > 0) out.know_power(rounded(shown_s0_.power / static_cast<double>(shown_s0_.whole)));
    return out;
}

TransferMethod& Pipeline::method_for(Method method) {
    if (method == Method::dense) return dense_;
    return factored_;
}

bool Pipeline::follows_smooth(const RenderOptions& options, const RenderExecutor& executor) const {
    return nicol::follows_rays(options.method, executor) && smooth_.any();
}

void Pipeline::shade(ShadeInput input, const Projection& projection, const RenderOptions& options,
                     const DistantLight& distant, RenderExecutor& executor, RenderRun& run) {
    const Stopwatch watch;
    const bool high_orders = distant.high > distant.low;
    if ((options.disabled_optimisations & skip_unchanged) != 0) shading_.reset();
    shading_.update(input, executor.version(), options.method, input.view, input.light_version,
                    distant.version, high_orders ? input.light_to_geometry : glm::dmat3(1.0),
                    factored_.bounces().version(), local_lights_.version(),
                    high_orders ? options.high_orders : HighOrders::none,
                    high_orders && !high_orders_.visibility()->empty(), options.physical, noise_,
                    input.light_factors, input.channels, input.least_components, input.most_components);
    if (executor.can_choose()) {
        choose_vertices(input.geometry, projection, options, run);
    } else {
        chosen_.assign(input.geometry.positions.size(), 1);
    }
    input.chosen = chosen_;
    method_for(options.method).shade(input, executor, run);
    if (high_orders) executor.specular(high_orders_, input, run);
    if (!input.light_factors.none()) executor.scale(input);
    if (options.physical) executor.make_physical(input);
    run.statistics.vertices_shaded += static_cast<std::uint64_t>(std::ranges::count(chosen_, 1));
    if (local_lights_.any()) {
        const Stopwatch lighting;
        // The executor has shaded all vertices; rays are traced only for vertices that can be seen.
        if (!executor.can_choose()) find_seen(input.geometry, projection, options, run);
        local_lights_.find_vertex_origins(visibility_.surfaces());
        executor.illuminate(local_lights_, input, run);
        run.statistics.light_ms += lighting.milliseconds();
    }
    run.statistics.vertices_unphysical += executor.finish();
    shading_.complete(chosen_);
    run.statistics.shade_ms += watch.milliseconds();
}

void Pipeline::choose_vertices(const WorldGeometry& geometry, const Projection& projection,
                               const RenderOptions& options, RenderRun& run) {
    find_seen(geometry, projection, options, run);
    const std::span current = shading_.current();
    for (std::size_t v = 0; v < chosen_.size(); ++v) chosen_[v] = chosen_[v] != 0 && current[v] == 0 ? 1 : 0;
}

std::span<const std::uint8_t> Pipeline::seen(const WorldGeometry& geometry, const Projection& projection,
                                             RenderRun& run) {
    seeing_.run(visibility_.surfaces().version(), projection.world_to_clip, projection.pixel,
                [&] { run.workers.run([&] { unseen_ = find_visible(geometry, projection, seen_); }); });
    return seen_;
}

void Pipeline::find_seen(const WorldGeometry& geometry, const Projection& projection,
                         const RenderOptions& options, RenderRun& run) {
    if ((options.disabled_optimisations & skip_hidden) != 0) {
        chosen_.assign(geometry.positions.size(), 1);
    } else {
        const std::span found = seen(geometry, projection, run);
        chosen_.assign(found.begin(), found.end());
        run.statistics.vertices_skipped = unseen_;
    }
}

void Pipeline::count(const TransferInput& input, const DistantLight& distant, Statistics& statistics) const {
    statistics.order_low = distant.low;
    statistics.order = distant.high;
    if (distant.high > distant.low) high_orders_.count(statistics);
    statistics.vertices = input.geometry.positions.size();
    statistics.triangles = input.geometry.triangles.size();
    const int light_channels = input.light.channels();
    statistics.light_columns_skipped =
        static_cast<std::uint64_t>((4 - static_cast<int>(input.layout.kind())) * light_channels);
    statistics.channels_shared = static_cast<std::uint64_t>(input.channels - light_channels);
    statistics.transfer_bytes += input.geometry.bytes() + chosen_.size() + smooth_.bytes();
}

}  // namespace nicol
