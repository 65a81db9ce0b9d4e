// SPDX-License-Identifier: MIT
// Bakes of vertices that the bake of a part has left out.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "render/bake_inputs.hpp"
#include "render/baked_vertices.hpp"
#include "render/scene_visibility.hpp"

namespace nicol {
namespace {

// Part by which the nearest vertex may come nearer before triangles that were as fine as pixels are refined.
constexpr double kNearer = 0.01;
// Part of the pixel in which points took what others see, down to which they keep it in further views.
constexpr double kSharedPixel = 0.75;
// A part p of the vertices grows for 16 (1 - p) views, then one view bakes all the rest. Each of these views
// takes about a sixteenth of a whole bake, so that a camera that goes on moving takes at most twice as long
// as if its first step had baked all.
constexpr std::size_t kGrownViews = 16;

}  // namespace

Visibility SceneVisibility::with_more(BakeGeometry geometry, const SceneGeometry& surfaces,
                                      std::span<const std::uint8_t> more,
                                      std::span<const std::uint8_t> outdated, const BakeProgress& report,
                                      BakeStatistics& baked) const {
    std::vector<std::uint8_t> room;
    geometry.needed = traced_of(surfaces.geometry(), more, room);
    geometry.needed_alone = room.empty();  // others than receivers count as unoccluded
    std::vector<Known> known;
    known.reserve(outdated.size());
    for (const std::uint8_t state : outdated) known.push_back(state != 0 ? Known::earlier : Known::nothing);
    const VertexRun all{.first = 0, .last = more.size(), .before = 0};
    const FormerBake former{.visibility = **baked_,
                            .kept = {&all, 1},
                            .disturbances = {},
                            .known = known,
                            .earlier = since_outdated_.disturbances()};
    Visibility visibility =
        nicol::bake(geometry, *directions_, report, &baked, any(outdated) ? &former : nullptr);
    for (std::size_t v = 0; v < more.size(); ++v)
        if (more[v] == 0) visibility.take(v, **baked_, v);
    return visibility;
}

Visibility SceneVisibility::bake_rest(const BakeGeometry& geometry, const SceneGeometry& surfaces,
                                      const BakeProgress& report, BakeStatistics& baked) const {
    std::vector<std::uint8_t> rest;
    rest.reserve(needed_.size());
    for (const std::uint8_t done : needed_) rest.push_back(done == kTraced ? 0 : 1);
    return with_more(geometry, surfaces, rest, outdated(false), report, baked);
}

void SceneVisibility::bake_missing(const SceneGeometry& surfaces, SurfaceRays& rays, double pixel,
                                   bool shared, const RenderOptions& options, const BakeProgress& report,
                                   std::vector<std::uint8_t>& missing, BakeStatistics& baked) {
    BakeGeometry geometry = geometry_of(surfaces, rays, {}, options);
    const std::vector<std::uint8_t> before = outdated(shared);
    std::vector<std::uint8_t> fresh = missing;
    for (std::size_t v = 0; v < before.size(); ++v)
        if (before[v] != 0) fresh[v] = 0;
    std::vector<std::uint32_t> like;
    if (pixel > 0 && !geometry.every_ray)
        geometry.like = like = vertices_in_pixels(surfaces.geometry(), fresh, pixel);
    auto all =
        std::make_shared<const Visibility>(with_more(geometry, surfaces, missing, before, report, baked));
    const bool has_points = points_bake_ == baked_.version();
    baked_.change() = std::move(all);
    if (has_points) points_bake_ = baked_.version();
    fresh = baked_vertices(std::move(fresh), like);
    for (std::size_t v = 0; v < missing.size(); ++v) {
        if (missing[v] == 0) continue;
        needed_[v] = missing[v] = fresh[v] != 0 ? fresh[v] : before[v];
        if (!outdated_.empty()) outdated_[v] = 0;
    }
}

bool SceneVisibility::shares(double edge) const {
    return edge >= kSharedPixel * traced_edge_;
}

void SceneVisibility::come_nearer(double edge) {
    if (edge < (1 - kNearer) * shortest_edge_) shortest_edge_ = edge;
    if (shares(edge)) return;
    outdated_ = outdated(false);
    traced_edge_ = edge;
    forget_points();
}

double SceneVisibility::shared_pixel(double pixel) const {
    return std::min(pixel, traced_edge_ / kPixelsOfEdge);
}

void SceneVisibility::refine_all() {
    shortest_edge_ = traced_edge_ = 0;
    wanted_.clear();
    forget_points();
}

void SceneVisibility::forget_points() {
    points_ = {};
    points_bake_ = 0;
}

bool SceneVisibility::is_enough(const NeededVertices& needed) const {
    if (needed.pixel == 0) return !needed.flags.empty();  // nothing is seen
    return kPixelsOfEdge * needed.pixel >= (1 - kNearer) * shortest_edge_ && contain(needed_, needed.flags) &&
           contain(wanted_, needed.seen);
}

bool SceneVisibility::grows() const {
    const std::vector<std::uint8_t>& part = needed_.empty() ? wanted_ : needed_;
    if (part.empty()) return false;  // nothing is left out but edges finer than pixels
    const auto left = static_cast<std::size_t>(std::ranges::count(part, 0));
    return views_since_ * part.size() <= kGrownViews * left;
}

void SceneVisibility::grow(const SceneGeometry& surfaces, SurfaceRays& rays, const NeededVertices& needed,
                           const RenderOptions& options, Workers& workers, Progress& progress,
                           Statistics& statistics) {
    const Stopwatch watch;
    const double edge = kPixelsOfEdge * needed.pixel;
    const bool shared = shares(edge);
    std::vector<std::uint8_t> missing(needed_.size(), 0);
    for (std::size_t v = 0; v < missing.size(); ++v) {
        const bool shown = needed.flags.empty() || needed.flags[v] != 0;
        missing[v] = needed_[v] == 0 ? shown : !shared && needed_[v] != kTraced;
    }
    BakeStatistics baked;
    if (any(missing)) {
        const double share = options.refine_tolerance > 0 ? kTracingOfBake : 1;
        workers.run([&] {
            bake_missing(
                surfaces, rays, shared_pixel(needed.pixel), shared, options,
                [&](double fraction) { progress.report("bake", share * fraction); }, missing, baked);
        });
    }
    for (std::size_t v = 0; v < wanted_.size(); ++v) wanted_[v] |= needed.seen[v];
    come_nearer(edge);
    carried_ = 0;
    refining_.reset();
    count_bake(baked, watch, statistics);
}

void SceneVisibility::keep_vertices(std::size_t vertices) {
    former_.resize(vertices);
    std::iota(former_.begin(), former_.end(), 0U);
    same_places_.assign(vertices, 1);
}

bool SceneVisibility::left_out_unsampled() const {
    return !progressive_ && uses_bake_ && versions_.visibility != 0 && seen_.sampled &&
           std::ranges::find(needed_, 0) != needed_.end();
}

void SceneVisibility::bake_shown(const SceneGeometry& surfaces, SurfaceRays& rays,
                                 const std::function<std::span<const std::uint8_t>()>& find_shown, bool lobes,
                                 const RenderOptions& options, RenderRun& run) {
    if (!left_out_unsampled()) return;
    const std::span<const std::uint8_t> shown = find_shown();
    const std::size_t given = needed_.size();
    const WorldGeometry& world = surfaces.geometry();
    std::vector<std::uint8_t> missing(given, 0);
    for (std::uint32_t v = 0; v < shown.size(); ++v) {
        const std::uint32_t i = numbers_.source(v);
        if (shown[v] == 0 || i >= given || needed_[i] != 0) continue;
        if (reflects(*world.ranges[range_of(world, i)].material)) missing[i] = 1;
    }
    if (!any(missing)) return;
    if (shows_others(world, missing, lobes))
        for (std::size_t i = 0; i < given; ++i) missing[i] = needed_[i] == 0 ? 1 : 0;
    std::vector<std::uint32_t> changed;  // vertices of surfaces_
    for (std::uint32_t v = 0; v < shown.size(); ++v) {
        const std::uint32_t i = numbers_.source(v);
        if (i < given && missing[i] != 0) changed.push_back(v);
    }
    const Stopwatch watch;
    const bool shadow_all = (options.disabled_optimisations & skip_unoccluded) != 0;
    BakeStatistics baked;
    run.workers.run([&] {
        bake_missing(
            surfaces, rays, 0, false, options,
            [&run](double fraction) { run.progress.report("bake", fraction); }, missing, baked);
        auto visible = std::make_shared<Visibility>(**visible_);
        for (const std::uint32_t v : changed) {
            visible->take(v, **baked_, numbers_.source(v));
            if (shadow_all) visible->set_unoccluded(v, false);
        }
        visible_.change() = std::move(visible);
    });
    possible_blockers_.reset();
    before_ = versions_;
    keep_vertices(shown.size());
    for (const std::uint32_t v : changed) {
        baked_vertices_[v] = kTraced;
        former_[v] = kNoVertex;
    }
    same_normals_.clear();
    versions_.visibility = visible_.version();
    shown_.show(*visible_);
    // The triangles of these few vertices stay as they are.
    refining_.run(baked_.version(), options.refine_tolerance, options.max_vertices, shadow_all,
                  shortest_edge_, [] {});
    count_bake(baked, watch, run.statistics);
}

}  // namespace nicol
