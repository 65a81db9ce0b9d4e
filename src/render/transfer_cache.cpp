// SPDX-License-Identifier: MIT
#include "render/transfer_cache.hpp"

#include <algorithm>
#include <glm/matrix.hpp>
#include <utility>

#include "render/rigid_motion.hpp"
#include "shading/physical_range.hpp"
#include "visibility/bake_cache.hpp"

namespace nicol {

void TransferCache::set_cache(const std::filesystem::path& folder, const CacheNotice& notice) {
    folder_ = folder;
    notice_ = notice;
    factored_.set_cache(folder, notice);
    high_orders_.set_cache(folder, notice);
}

void TransferCache::update(const Scene& scene, const Projection& of_world, const RenderOptions& asked,
                           ComputeExecutor* device, Progress& progress, Statistics& statistics) {
    follow_geometry(scene, asked, progress, statistics);
    const WorldGeometry& geometry = surfaces_.geometry();
    const RenderOptions options = choose_orders(scene, asked, statistics);
    // The scene's turn as a whole is one of light and camera the other way.
    const Projection projection = in_axes(of_world, surfaces_.to_world());
    const glm::dmat3 light_to_axes =
        glm::transpose(glm::dmat3(surfaces_.to_world())) * scene.light_rotation();
    light_.update(scene, options, light_to_axes, statistics);
    const std::uint64_t visibility = shadowed_ ? visibility_revision_ : 0;
    const TransferInput input{
        .geometry = geometry,
        .geometry_revision = surfaces_.revision(),
        .material_revision = surfaces_.material_revision(),
        .layout = light_.layout(),
        .light = light_.rotated(),
        .light_revision = light_.rotated_revision(),
        .channels = scene.channels(),
        .visibility = shadowed_ ? &visibility_ : nullptr,
        .directions = shadowed_ ? &*directions_ : nullptr,
        .visibility_revision = visibility,
        .least_components = (options.disabled_optimisations & skip_response_rows) != 0 ? 4U : 1U,
        .most_components = static_cast<std::size_t>(options.components),
        .unchanged = follows_ ? std::optional(Unchanged{.geometry = last_geometry_,
                                                        .visibility = last_visibility_,
                                                        .vertices = unchanged_})
                              : std::nullopt};
    const DistantLight distant{.coefficients = light_.distant(),
                               .revision = light_.distant_revision(),
                               .to_world = light_to_axes,
                               .low = options.order_low,
                               .high = light_.last_order(),
                               .polarized = input.layout.kind() != LightKind::unpolarized};
    TransferInput high_input = input;
    if (!options.high_order_shadows) {
        high_input.visibility = nullptr;
        high_input.visibility_revision = 0;
        high_input.unchanged.reset();
    }
    const bool high_orders = distant.high > distant.low;
    at_pixels_ = high_orders && options.high_orders_at == HighOrdersAt::pixels;
    const bool physical = options.physical && !at_pixels_;  // else it comes once all orders are there
    const auto on_host = [&](auto& method) {
        method.relight(input, workers_, progress, statistics);
        const Stopwatch watch;
        if ((options.disabled_optimisations & skip_hidden) != 0) {
            visible_.assign(geometry.positions.size(), 1);
        } else {
            workers_.run([&] { statistics.vertices_skipped = find_visible(geometry, projection, visible_); });
        }
        stokes_.resize(static_cast<std::size_t>(input.channels));
        for (auto& channel : stokes_) channel.resize(geometry.positions.size());
        // What has been moved into the physical range is not counted again.
        if (physical || (options.disabled_optimisations & skip_unchanged) != 0) shaded_.forget();
        shaded_.follow({.view = projection.view,
                        .method = options.method,
                        .high_orders = high_orders ? options.high_orders : HighOrders::none,
                        .at_pixels = at_pixels_,
                        .order_low = distant.low,
                        .order_high = distant.high,
                        .light = input.light_revision,
                        .distant = distant.revision,
                        .shadowed = input.visibility != nullptr,
                        .high_shadowed = high_input.visibility != nullptr,
                        .channels = input.channels,
                        .least_components = input.least_components,
                        .most_components = input.most_components},
                       input, surfaces_.change().same_places);
        const std::span<const std::uint8_t> chosen = shaded_.choose(visible_);
        statistics.vertices_shaded += shaded_.chosen_count();
        method.shade(input, projection.view, chosen, workers_, progress, stokes_);
        if (at_pixels_) {
            high_orders_.see(high_input, projection.view, chosen, workers_, progress);
        } else if (high_orders) {
            high_orders_.shade(high_input, distant, projection.view, chosen, workers_, progress, stokes_);
        }
        if (physical) {
            for (auto& channel : stokes_) statistics.vertices_unphysical += make_physical(channel);
        }
        shaded_.done();
        statistics.shade_ms += watch.milliseconds();
    };
    const auto compute = [&](auto& method) {
        TransferInput low_input = input;
        if (high_orders) low_input.awaited = high_orders_.await(high_input, distant.low);
        method.prepare(low_input, workers_, progress, statistics);
        if (high_orders) {
            high_orders_.update(high_input, distant, options.high_orders, workers_, progress, statistics);
        }
        if (device == nullptr) {
            on_host(method);
        } else {
            shaded_.forget();
            device->run(method,
                        {.high_orders = high_orders ? &high_orders_ : nullptr,
                         .at_pixels = at_pixels_,
                         .physical = physical},
                        input, distant, projection.view, progress, statistics);
        }
        if (high_orders) high_orders_.count(statistics);
        method.count(input, statistics);
    };
    if (options.method == Method::dense) {
        compute(dense_);
    } else {
        compute(factored_);
    }

    statistics.order_low = distant.low;
    statistics.order = distant.high;
    if (high_orders) {
        statistics.high_orders_at = at_pixels_ ? HighOrdersAt::pixels : HighOrdersAt::vertices;
    }
    statistics.vertices = geometry.positions.size();
    statistics.triangles = geometry.triangles.size();
    const int light_channels = input.light.channels();
    statistics.light_columns_skipped =
        static_cast<std::uint64_t>((4 - static_cast<int>(input.layout.kind())) * light_channels);
    statistics.channels_shared = static_cast<std::uint64_t>(input.channels - light_channels);
    statistics.vertices_unoccluded = shadowed_ ? visibility_.unoccluded_count() : geometry.positions.size();
    statistics.visibility_bytes = options.shadows ? visibility_.bytes() : 0;
    statistics.transfer_bytes +=
        geometry.bytes() + visible_.size() + stokes_.size() * geometry.positions.size() * sizeof(glm::vec4);
    last_geometry_ = input.geometry_revision;
    last_visibility_ = input.visibility_revision;
}

void TransferCache::follow_geometry(const Scene& scene, const RenderOptions& options, Progress& progress,
                                    Statistics& statistics) {
    surfaces_.update(scene);
    const SceneGeometry::Change& change = surfaces_.change();
    const bool moved = last_geometry_ != surfaces_.revision();
    const bool was_shadowed = last_visibility_ != 0;
    const bool kept_bake = was_shadowed && last_visibility_ == visibility_revision_;
    follows_ = moved && change.before != 0 && change.before == last_geometry_;
    if (follows_) unchanged_ = change.same_normals;
    // Darkness casts no shadows.
    if (options.shadows && scene.environment()) bake(options, progress, statistics);
    shadowed_ = options.shadows && baked_geometry_ == surfaces_.revision() &&
                visibility_.unoccluded_count() < visibility_.vertices();
    // Shadows that were not there before, or no longer are, change everything.
    follows_ = follows_ && was_shadowed == shadowed_ && (!shadowed_ || (kept_bake && rebaked_));
}

RenderOptions TransferCache::choose_orders(const Scene& scene, const RenderOptions& options,
                                           Statistics& statistics) {
    RenderOptions chosen = options;
    if (!(options.tolerance > 0)) return chosen;
    const Stopwatch watch;
    workers_.run([&] {
        const OrderSelector::Orders orders =
            budget_.choose(scene, surfaces_.geometry(), surfaces_.revision() + surfaces_.material_revision(),
                           {.visibility = shadowed_ ? &visibility_ : nullptr,
                            .directions = shadowed_ ? &*directions_ : nullptr,
                            .revision = visibility_revision_},
                           options.tolerance, options.high_orders == HighOrders::split);
        chosen.order_low = orders.low;
        chosen.order_high = orders.high;
        statistics.predicted_error = orders.error;
    });
    statistics.project_ms += watch.milliseconds();
    return chosen;
}

void TransferCache::bake(const RenderOptions& options, Progress& progress, Statistics& statistics) {
    rebaked_ = false;
    const bool same_lattice =
        lattice_ && lattice_->size() == static_cast<std::size_t>(options.bake_directions);
    const bool same_directions = same_lattice && directions_axes_ == surfaces_.own_axes();
    const bool shadow_all = (options.disabled_optimisations & skip_unoccluded) != 0;
    if (same_directions && baked_geometry_ == surfaces_.revision() && shadow_all_ == shadow_all) return;
    const Stopwatch watch;
    const SceneGeometry::Change& change = surfaces_.change();
    const bool follows = same_directions && !shadow_all && !shadow_all_ && !change.kept.empty() &&
                         baked_geometry_ != 0 && baked_geometry_ == change.before;
    baked_geometry_ = 0;
    if (!same_lattice) lattice_.emplace(options.bake_directions);
    if (!same_directions) {
        directions_ = lattice_->rotated(surfaces_.own_axes());
        directions_axes_ = surfaces_.own_axes();
    }
    const WorldGeometry& surfaces = surfaces_.geometry();
    const BakeGeometry geometry{
        .positions = surfaces.positions, .normals = surfaces.normals, .triangles = surfaces.triangles};
    const auto tell = [&progress](double fraction) { progress.report("bake", fraction); };
    BakeStatistics baked;
    workers_.run([&] {
        if (follows) {
            const FormerBake former{
                .visibility = visibility_, .kept = change.kept, .disturbances = change.disturbances};
            Visibility visibility = nicol::bake(geometry, *directions_, tell, &baked, &former);
            for (std::size_t v = 0; follows_ && v < unchanged_.size(); ++v) {
                if (unchanged_[v] != 0 && !std::ranges::equal(visibility.at(v), visibility_.at(v)))
                    unchanged_[v] = 0;
            }
            visibility_ = std::move(visibility);
        } else {
            visibility_ = load_or_bake(geometry, *directions_, folder_, notice_, tell, &baked);
        }
    });
    rebaked_ = follows;
    if (shadow_all) {
        for (std::size_t v = 0; v < visibility_.vertices(); ++v) visibility_.set_unoccluded(v, false);
    }
    shadow_all_ = shadow_all;
    baked_geometry_ = surfaces_.revision();
    ++visibility_revision_;
    statistics.bake_rays += baked.rays;
    statistics.bake_trace_ms += baked.milliseconds;
    statistics.vertices_traced += baked.vertices;
    statistics.bake_ms += watch.milliseconds();
}

}  // namespace nicol
