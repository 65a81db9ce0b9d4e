// SPDX-License-Identifier: MIT
#include "render/transfer_cache.hpp"

#include <algorithm>
#include <utility>

#include "nicol/rotation.hpp"
#include "transfer/bake_cache.hpp"

namespace nicol {
namespace {

LightKind kind_of(const EnvironmentPtr& environment) {
    if (!environment || !environment->polarized()) return LightKind::unpolarized;
    return environment->circular() ? LightKind::full : LightKind::linear;
}

// The first channel alone where all are equal.
PshVector without_repeats(PshVector light) {
    for (int c = 1; c < light.channels(); ++c) {
        if (!std::ranges::equal(light.channel(c), light.channel(0))) return light;
    }
    PshVector single(light.order(), 1);
    std::ranges::copy(light.channel(0), single.channel(0).begin());
    return single;
}

}  // namespace

void TransferCache::set_cache(const std::filesystem::path& folder, const CacheNotice& notice) {
    folder_ = folder;
    notice_ = notice;
    factored_.set_cache(folder, notice);
}

void TransferCache::update(const Scene& scene, const Projection& projection, const RenderOptions& options,
                           Progress& progress, Statistics& statistics) {
    if (geometry_revision_ != scene.geometry_revision()) {
        geometry_ = world_geometry(scene);
        geometry_revision_ = scene.geometry_revision();
    }
    project_light(scene, options.order_low, statistics);
    turn_light(scene, statistics);
    if (options.shadows) bake(scene, options, progress, statistics);
    const bool shadowed = options.shadows && visibility_revision_ == geometry_revision_ &&
                          visibility_.unoccluded_count() < visibility_.vertices();
    const TransferInput input{.geometry = geometry_,
                              .geometry_revision = geometry_revision_,
                              .layout = *layout_,
                              .light = turned_,
                              .light_revision = light_revision_,
                              .channels = scene.channels(),
                              .visibility = shadowed ? &visibility_ : nullptr,
                              .directions = shadowed ? &*directions_ : nullptr,
                              .visibility_revision = shadowed ? visibility_revision_ : 0,
                              .horizon = options.horizon};
    const auto compute = [&](auto& method) {
        method.update(input, workers_, progress, statistics);
        const Stopwatch watch;
        statistics.vertices_skipped = find_visible(geometry_, projection, visible_);
        stokes_.resize(static_cast<std::size_t>(input.channels));
        for (auto& channel : stokes_) channel.resize(geometry_.positions.size());
        method.shade(input, projection.view, visible_, workers_, progress, stokes_);
        statistics.shade_ms += watch.milliseconds();
        method.count(input, statistics);
    };
    if (options.method == Method::dense) {
        compute(dense_);
    } else {
        compute(factored_);
    }

    statistics.order = layout_->order();
    statistics.vertices = geometry_.positions.size();
    statistics.triangles = geometry_.triangles.size();
    statistics.light_columns_skipped = static_cast<std::uint64_t>(4 - static_cast<int>(layout_->kind())) *
                                       static_cast<std::uint64_t>(light_.channels());
    statistics.channels_shared = static_cast<std::uint64_t>(input.channels - light_.channels());
    statistics.vertices_unoccluded = shadowed ? visibility_.unoccluded_count() : geometry_.positions.size();
    statistics.visibility_bytes = options.shadows ? visibility_.bytes() : 0;
    statistics.transfer_bytes +=
        geometry_.bytes() + visible_.size() + stokes_.size() * geometry_.positions.size() * sizeof(glm::vec4);
}

void TransferCache::bake(const Scene& scene, const RenderOptions& options, Progress& progress,
                         Statistics& statistics) {
    const bool same_directions =
        directions_ && directions_->size() == static_cast<std::size_t>(options.bake_directions);
    if (same_directions && visibility_revision_ == geometry_revision_) return;
    if (!scene.environment()) return;  // darkness casts no shadows
    const Stopwatch watch;
    visibility_revision_ = 0;
    if (!same_directions) directions_.emplace(options.bake_directions);
    const BakeGeometry geometry{
        .positions = geometry_.positions, .normals = geometry_.normals, .triangles = geometry_.triangles};
    BakeStatistics baked;
    workers_.run([&] {
        visibility_ = load_or_bake(
            geometry, *directions_, folder_, notice_,
            [&progress](double fraction) { progress.report("bake", fraction); }, &baked);
    });
    visibility_revision_ = geometry_revision_;
    statistics.bake_rays += baked.rays;
    statistics.bake_trace_ms += baked.milliseconds;
    statistics.bake_ms += watch.milliseconds();
}

void TransferCache::project_light(const Scene& scene, int order, Statistics& statistics) {
    const LightKind kind = kind_of(scene.environment());
    const bool same_layout = layout_ && layout_->order() == order && layout_->kind() == kind;
    if (same_layout && environment_ == scene.environment()) return;
    const Stopwatch watch;
    scene_light_revision_ = 0;
    environment_ = scene.environment();
    light_ = environment_ ? without_repeats(environment_->project(order)) : PshVector(order, 1);
    layout_.emplace(order, kind);
    statistics.project_ms += watch.milliseconds();
}

void TransferCache::turn_light(const Scene& scene, Statistics& statistics) {
    if (scene_light_revision_ == scene.light_revision()) return;
    const Stopwatch watch;
    turned_ = rotated(light_, scene.light_rotation());
    for (double& coefficient : turned_.data()) coefficient *= scene.light_scale();
    scene_light_revision_ = scene.light_revision();
    ++light_revision_;
    statistics.relight_ms += watch.milliseconds();
}

}  // namespace nicol
