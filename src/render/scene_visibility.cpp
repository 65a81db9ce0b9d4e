// SPDX-License-Identifier: MIT
#include "render/scene_visibility.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "visibility/bake_cache.hpp"

namespace nicol {

void SceneVisibility::set_cache(std::filesystem::path folder, CacheNotice notice) {
    folder_ = std::move(folder);
    notice_ = std::move(notice);
}

void SceneVisibility::update(const SceneGeometry& surfaces, bool lit, const RenderOptions& options,
                             Workers& workers, Progress& progress, Statistics& statistics) {
    const SurfaceVersions former = versions_;
    const bool had_bake = former.visibility == visibility_.version();
    const bool follows = former.geometry != surfaces.version() && former.geometry != 0 &&
                         former.geometry == surfaces.change().before;
    if (follows) same_field_ = surfaces.change().same_normals;
    const bool carried =
        options.shadows && lit && bake(surfaces, follows, options, workers, progress, statistics);

    const std::size_t unoccluded = visibility_->unoccluded_count();
    const bool shadowed =
        options.shadows && baked_ == surfaces.version() && unoccluded < visibility_->vertices();
    versions_ = {.geometry = surfaces.version(), .visibility = shadowed ? visibility_.version() : 0};
    statistics.vertices_unoccluded = shadowed ? unoccluded : surfaces.geometry().positions.size();
    statistics.visibility_bytes = options.shadows ? visibility_->bytes() : 0;
    if (versions_ == former) return;
    // Shadows that were not there before, or no longer are, change everything.
    const bool comparable = shadowed ? had_bake && carried : former.visibility == 0;
    before_ = follows && comparable ? std::optional(former) : std::nullopt;
}

SurfaceState SceneVisibility::state(const SceneGeometry& surfaces) const {
    const bool shadowed = versions_.visibility != 0;
    std::optional<SurfaceChange> change;
    if (before_) {
        change = {
            .before = *before_, .same_field = same_field_, .same_places = surfaces.change().same_places};
    }
    return {.geometry = surfaces.geometry(),
            .visibility = shadowed ? &*visibility_ : nullptr,
            .directions = shadowed ? &*directions_ : nullptr,
            .versions = versions_,
            .materials = surfaces.material_version(),
            .change = change};
}

bool SceneVisibility::bake(const SceneGeometry& surfaces, bool narrow, const RenderOptions& options,
                           Workers& workers, Progress& progress, Statistics& statistics) {
    const int count = options.bake_directions;
    const glm::dmat3& axes = surfaces.own_axes();
    const bool shadow_all = (options.disabled_optimisations & skip_unoccluded) != 0;
    const SceneGeometry::Change& change = surfaces.change();
    const bool carry =
        !shadow_all && !change.kept.empty() && baking_.is_current(change.before, count, axes, false);
    const bool ran = baking_.run(surfaces.version(), count, axes, shadow_all, [&] {
        const Stopwatch watch;
        baked_ = 0;
        spreading_.run(count, [&] { lattice_.emplace(count); });
        rotating_.run(count, axes, [&] { directions_ = lattice_->rotated(axes); });
        const WorldGeometry& world = surfaces.geometry();
        const BakeGeometry geometry{
            .positions = world.positions, .normals = world.normals, .triangles = world.triangles};
        const auto report = [&progress](double fraction) { progress.report("bake", fraction); };
        BakeStatistics baked;
        workers.run([&] {
            if (carry) {
                const FormerBake former{
                    .visibility = *visibility_, .kept = change.kept, .disturbances = change.disturbances};
                Visibility visibility = nicol::bake(geometry, *directions_, report, &baked, &former);
                for (std::size_t v = 0; narrow && v < same_field_.size(); ++v) {
                    if (same_field_[v] != 0 && !std::ranges::equal(visibility.at(v), visibility_->at(v)))
                        same_field_[v] = 0;
                }
                visibility_.change() = std::move(visibility);
            } else {
                visibility_.change() = load_or_bake(geometry, *directions_, folder_, notice_, report, &baked);
            }
        });
        for (std::size_t v = 0; shadow_all && v < visibility_->vertices(); ++v) {
            visibility_.change().set_unoccluded(v, false);
        }
        baked_ = surfaces.version();
        statistics.bake_rays += baked.rays;
        statistics.bake_trace_ms += baked.milliseconds;
        statistics.vertices_traced += baked.vertices;
        statistics.bake_ms += watch.milliseconds();
    });
    return ran && carry;
}

}  // namespace nicol
