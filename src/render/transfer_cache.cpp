// SPDX-License-Identifier: MIT
#include "render/transfer_cache.hpp"

#include "geometry/principal_axes.hpp"
#include "transfer/bake_cache.hpp"
#include "transfer/physical_range.hpp"

namespace nicol {

void TransferCache::set_cache(const std::filesystem::path& folder, const CacheNotice& notice) {
    folder_ = folder;
    notice_ = notice;
    factored_.set_cache(folder, notice);
    high_orders_.set_cache(folder, notice);
}

void TransferCache::update(const Scene& scene, const Projection& projection, const RenderOptions& asked,
                           ComputeExecutor* device, Progress& progress, Statistics& statistics) {
    if (geometry_revision_ != scene.geometry_revision()) {
        geometry_ = world_geometry(scene);
        geometry_revision_ = scene.geometry_revision();
    }
    if (asked.shadows) bake(scene, asked, progress, statistics);
    const bool shadowed = asked.shadows && baked_geometry_ == geometry_revision_ &&
                          visibility_.unoccluded_count() < visibility_.vertices();
    const RenderOptions options = choose_orders(scene, asked, shadowed, statistics);
    light_.update(scene, options, statistics);
    const TransferInput input{.geometry = geometry_,
                              .geometry_revision = geometry_revision_,
                              .layout = light_.layout(),
                              .light = light_.turned(),
                              .light_revision = light_.turned_revision(),
                              .channels = scene.channels(),
                              .visibility = shadowed ? &visibility_ : nullptr,
                              .directions = shadowed ? &*directions_ : nullptr,
                              .visibility_revision = shadowed ? visibility_revision_ : 0,
                              .horizon = options.horizon,
                              .least_components = (options.unskipped & skip_response_rows) != 0 ? 4U : 1U,
                              .most_components = static_cast<std::size_t>(options.components)};
    const DistantLight distant{.coefficients = light_.distant(),
                               .revision = light_.distant_revision(),
                               .to_world = scene.light_rotation(),
                               .low = options.order_low,
                               .high = light_.last_order(),
                               .polarized = input.layout.kind() != LightKind::unpolarized};
    TransferInput high_input = input;
    if (!options.high_order_shadows) {
        high_input.visibility = nullptr;
        high_input.visibility_revision = 0;
    }
    const bool high_orders = distant.high > distant.low;
    at_pixels_ = high_orders && options.high_orders_at == HighOrdersAt::pixels;
    const bool physical = options.physical && !at_pixels_;  // else it comes once all orders are there
    if (high_orders) {
        high_orders_.update(high_input, distant, options.high_orders, workers_, progress, statistics);
    }
    const auto on_host = [&](auto& method) {
        method.relight(input, workers_, progress, statistics);
        const Stopwatch watch;
        if ((options.unskipped & skip_hidden) != 0) {
            visible_.assign(geometry_.positions.size(), 1);
        } else {
            workers_.run(
                [&] { statistics.vertices_skipped = find_visible(geometry_, projection, visible_); });
        }
        stokes_.resize(static_cast<std::size_t>(input.channels));
        for (auto& channel : stokes_) channel.resize(geometry_.positions.size());
        method.shade(input, projection.view, visible_, workers_, progress, stokes_);
        if (high_orders) {
            high_orders_.see(high_input, projection.view, visible_, workers_, progress);
            if (!at_pixels_) {
                high_orders_.shade(high_input, distant, projection.view, visible_, workers_, progress,
                                   stokes_);
            }
        }
        if (physical) {
            for (auto& channel : stokes_) statistics.vertices_unphysical += make_physical(channel);
        }
        statistics.shade_ms += watch.milliseconds();
    };
    const auto compute = [&](auto& method) {
        method.prepare(input, workers_, progress, statistics);
        if (device == nullptr) {
            on_host(method);
        } else {
            device->run(method,
                        {.high_orders = high_orders ? &high_orders_ : nullptr,
                         .at_pixels = at_pixels_,
                         .physical = physical},
                        input, distant, projection.view, workers_, progress, statistics);
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
    statistics.vertices = geometry_.positions.size();
    statistics.triangles = geometry_.triangles.size();
    const int light_channels = input.light.channels();
    statistics.light_columns_skipped =
        static_cast<std::uint64_t>((4 - static_cast<int>(input.layout.kind())) * light_channels);
    statistics.channels_shared = static_cast<std::uint64_t>(input.channels - light_channels);
    statistics.vertices_unoccluded = shadowed ? visibility_.unoccluded_count() : geometry_.positions.size();
    statistics.visibility_bytes = options.shadows ? visibility_.bytes() : 0;
    statistics.transfer_bytes +=
        geometry_.bytes() + visible_.size() + stokes_.size() * geometry_.positions.size() * sizeof(glm::vec4);
}

RenderOptions TransferCache::choose_orders(const Scene& scene, const RenderOptions& options, bool shadowed,
                                           Statistics& statistics) {
    RenderOptions chosen = options;
    if (!(options.tolerance > 0)) return chosen;
    const Stopwatch watch;
    workers_.run([&] {
        const ErrorBudget::Orders orders =
            budget_.choose(scene, geometry_,
                           {.visibility = shadowed ? &visibility_ : nullptr,
                            .directions = shadowed ? &*directions_ : nullptr,
                            .revision = visibility_revision_,
                            .horizon = options.horizon},
                           options.tolerance, options.high_orders == HighOrders::split);
        chosen.order_low = orders.low;
        chosen.order_high = orders.high;
        statistics.predicted_error = orders.error;
    });
    statistics.project_ms += watch.milliseconds();
    return chosen;
}

void TransferCache::bake(const Scene& scene, const RenderOptions& options, Progress& progress,
                         Statistics& statistics) {
    const bool same_directions =
        lattice_ && lattice_->size() == static_cast<std::size_t>(options.bake_directions);
    const bool shadow_all = (options.unskipped & skip_unoccluded) != 0;
    if (same_directions && baked_geometry_ == geometry_revision_ && shadow_all_ == shadow_all) return;
    if (!scene.environment()) return;  // darkness casts no shadows
    const Stopwatch watch;
    baked_geometry_ = 0;
    if (!same_directions) lattice_.emplace(options.bake_directions);
    // Turned with the scene, so that a scene that is turned as a whole has the same shadows.
    directions_ = lattice_->turned(principal_axes(geometry_.positions));
    const BakeGeometry geometry{
        .positions = geometry_.positions, .normals = geometry_.normals, .triangles = geometry_.triangles};
    BakeStatistics baked;
    workers_.run([&] {
        visibility_ = load_or_bake(
            geometry, *directions_, folder_, notice_,
            [&progress](double fraction) { progress.report("bake", fraction); }, &baked);
    });
    if (shadow_all) {
        for (std::size_t v = 0; v < visibility_.vertices(); ++v) visibility_.set_unoccluded(v, false);
    }
    shadow_all_ = shadow_all;
    baked_geometry_ = geometry_revision_;
    ++visibility_revision_;
    statistics.bake_rays += baked.rays;
    statistics.bake_trace_ms += baked.milliseconds;
    statistics.bake_ms += watch.milliseconds();
}

}  // namespace nicol
