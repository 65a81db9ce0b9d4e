// SPDX-License-Identifier: MIT
#include "render/scene_visibility.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

#include "render/bake_inputs.hpp"
#include "render/baked_vertices.hpp"
#include "render/carried_states.hpp"
#include "render/needed_vertices.hpp"
#include "render/shifted_objects.hpp"
#include "visibility/bake_cache.hpp"
#include "visibility/possible_blockers.hpp"

namespace nicol {
namespace {

// Directions, as a part of all, times the tolerance of shadows, in which a vertex may see something else than
// before the change of a scene and keep its light.
constexpr double kUnshown = 1.0 / 16;
// Changes of a scene after which vertices that have not followed them are baked from scratch: the balls that
// the record of these changes has joined reach so far that they disturb nearly all rays.
constexpr std::size_t kMostChanges = 24;

// Returns the number of unoccluded vertices among those that were baked. Empty: all were.
std::size_t unoccluded_count(const Visibility& visibility, std::span<const std::uint8_t> baked) {
    std::size_t count = visibility.unoccluded_count();
    for (std::size_t v = 0; v < baked.size(); ++v)
        if (baked[v] == 0 && visibility.unoccluded(v)) --count;
    return count;
}

}  // namespace

void SceneVisibility::set_cache(std::filesystem::path folder, CacheNotice notice) {
    folder_ = std::move(folder);
    notice_ = std::move(notice);
}

void SceneVisibility::update(const SceneGeometry& surfaces, SurfaceRays& rays, bool lit,
                             const BakedImages& images, const RenderOptions& options, Workers& workers,
                             Progress& progress, Statistics& statistics) {
    if (!options.shadows || !lit) progressive_.reset();
    possible_blockers_.reset();
    grew_ = false;
    if (options.shadows && lit && (options.bake_budget_ms > 0 || progressive_))
        return update_progressively(surfaces, rays, images.views, options, workers, progress, statistics);
    const SurfaceVersions former = versions_;
    const bool had_bake = former.visibility == visible_.version();
    const bool carried =
        options.shadows && lit && bake(surfaces, rays, images, options, workers, progress, statistics);
    uses_bake_ = options.shadows && baked_geometry_ == surfaces.version();
    if (uses_bake_) refine(surfaces, rays, options, workers, progress, statistics);
    possible_blockers_.reset();
    surfaces_.update(surfaces, uses_bake_ ? refined_ : nullptr, parts_, numbers_.numbers);

    const std::size_t vertices = surfaces_.geometry().positions.size();
    const bool shadowed = uses_bake_ && (*visible_)->unoccluded_count() < vertices;
    versions_ = {.geometry = surfaces_.version(), .visibility = shadowed ? visible_.version() : 0};
    if (!shadowed) shown_.show(*visible_);
    if (versions_ == former) return;
    before_.reset();
    // All vertices change if shadows appear or disappear.
    const bool same_shadows = shadowed ? had_bake && carried : former.visibility == 0;
    const bool same_geometry = former.geometry == versions_.geometry;
    if (former.geometry == 0 || !same_shadows ||
        (!same_geometry && former.geometry != surfaces_.change().before))
        return shown_.show(*visible_);
    before_ = former;
    if (same_geometry) {
        keep_vertices(vertices);
    } else {
        former_ = surfaces_.change().former;
        same_places_ = surfaces_.change().same_places;
    }
    same_normals_.clear();
    if (!shadowed) return;
    const double negligible =
        traces_all(options) ? 0
                            : kUnshown * options.refine_tolerance * static_cast<double>(directions_->size());
    workers.run([&] { shown_.follow(*visible_, former_, static_cast<std::size_t>(negligible)); });
}

void SceneVisibility::count(const SceneGeometry& surfaces, Statistics& statistics) const {
    const std::size_t vertices = surfaces_.geometry().positions.size();
    statistics.vertices_added = vertices - surfaces.geometry().positions.size();
    statistics.vertices_unoccluded = vertices;
    if (progressive_) {
        statistics.vertices_unoccluded = progressive_->visibility().unoccluded_count();
        statistics.vertices_pending = progressive_->pending();
        statistics.visibility_bytes = progressive_->bytes();
    } else if (uses_bake_) {
        statistics.vertices_unbaked = static_cast<std::uint64_t>(std::ranges::count(needed_, 0));
        statistics.vertices_unoccluded = unoccluded_count(**visible_, baked_vertices_);
        statistics.visibility_bytes = (*visible_)->bytes() + points_.bytes();
        if (*baked_ != *visible_) statistics.visibility_bytes += (*baked_)->bytes();
        if (shown_.get() != visible_->get()) statistics.visibility_bytes += shown_.get()->bytes();
    }
}

SurfaceState SceneVisibility::state() const {
    const bool shadowed = versions_.visibility != 0;
    std::optional<SurfaceChange> change;
    if (before_) {
        change = {.before = *before_,
                  .former = former_,
                  .same_places = same_places_,
                  .same_normals = same_normals_};
    }
    return {
        .geometry = surfaces_.geometry(),
        .visibility = !shadowed      ? nullptr
                      : progressive_ ? &progressive_->visibility()
                                     : shown_.get(),
        .directions = shadowed ? &*directions_ : nullptr,
        .versions = versions_,
        .materials = surfaces_.material_version(),
        .change = change,
        .baked = shadowed ? std::span<const std::uint8_t>(baked_vertices_) : std::span<const std::uint8_t>()};
}

void SceneVisibility::find_directions(const SceneGeometry& surfaces, const RenderOptions& options) {
    const int count = options.bake_directions;
    const glm::dmat3& axes = surfaces.own_axes();
    spreading_.run(count, [&] { lattice_.emplace(count); });
    rotating_.run(count, axes, [&] {
        directions_ = lattice_->rotated(axes);
        axes_ = new_version();
    });
}

void SceneVisibility::begin_progressively(const SceneGeometry& surfaces, const RenderOptions& options) {
    progressive_ = std::make_unique<ProgressiveBake>();
    const bool fine = shortest_edge_ == 0;
    // Bake of the last update(), if it has these directions and belongs to the surfaces before or after their
    // last change.
    const bool current = baked_geometry_ != 0 &&
                         baking_.is_current(baked_geometry_, options.bake_directions, surfaces.own_axes()) &&
                         refining_.is_current(baked_.version(), options.refine_tolerance,
                                              options.max_vertices, false, shortest_edge_);
    const bool follows = baked_geometry_ == surfaces.version() || baked_geometry_ == surfaces.change().before;
    if (current && follows) {
        for (std::uint8_t& state : baked_vertices_) state = state == kTraced ? 1 : 0;
        progressive_->begin({.surfaces = baked_geometry_,
                             .axes = axes_,
                             .given = (*baked_)->vertices(),
                             .topology = std::move(topology_),
                             .visibility = **visible_,
                             .refined = std::move(refined_),
                             .parts = std::move(parts_),
                             .numbers = std::move(numbers_),
                             .points = fine ? std::move(points_) : TracedPoints(),
                             .fine = fine,
                             .tolerance = options.refine_tolerance,
                             .most_vertices = options.max_vertices,
                             .baked = std::move(baked_vertices_),
                             .normals = surfaces_.geometry().normals,
                             .lagging = shown_.lagging()});
    } else {
        versions_.visibility = 0;
    }
    topology_ = {};
    refined_.reset();
    parts_.clear();
    numbers_ = {};
    forget_points();
    baked_.change().reset();
    visible_.change().reset();
    shown_.show(nullptr);
    baked_geometry_ = 0;
    needed_.clear();
    outdated_.clear();
    wanted_.clear();
    shortest_edge_ = 0;
    baked_vertices_.clear();
    baking_.reset();
    refining_.reset();
}

void SceneVisibility::update_progressively(const SceneGeometry& surfaces, SurfaceRays& rays,
                                           std::span<const Projection> views, const RenderOptions& options,
                                           Workers& workers, Progress& progress, Statistics& statistics) {
    const Stopwatch watch;
    find_directions(surfaces, options);
    if (!progressive_) begin_progressively(surfaces, options);
    const SurfaceVersions former = versions_;
    const ProgressiveBake::Input input{
        .surfaces = surfaces, .directions = *directions_, .axes = axes_, .options = options, .views = views};
    workers.run([&] { progressive_->follow(input); });
    BakeStatistics baked;
    if (progressive_->pending() > 0) {
        const bool limited = options.bake_budget_ms > 0;
        progressive_->advance(
            input, rays,
            limited ? options.bake_budget_ms - watch.milliseconds() : std::numeric_limits<double>::infinity(),
            workers, progress, baked);
    }
    surfaces_.update(surfaces, progressive_->refined(), progressive_->parts(), progressive_->numbers());
    const Visibility& visible = progressive_->visibility();
    const std::size_t vertices = visible.vertices();
    versions_.geometry = surfaces_.version();
    if (progressive_->any_changed() || former.visibility == 0) versions_.visibility = new_version();
    count_bake(baked, watch, statistics);
    progressive_->published();
    if (versions_ == former) return;
    before_.reset();
    const bool same_geometry = versions_.geometry == former.geometry;
    if (former.visibility == 0 || former.geometry == 0) return;
    if (!same_geometry && surfaces_.change().before != former.geometry) return;
    before_ = former;
    former_.assign(progressive_->former().begin(), progressive_->former().end());
    same_places_.assign(vertices, 1);
    same_normals_.assign(progressive_->same_normals().begin(), progressive_->same_normals().end());
    if (same_geometry) return;
    for (std::size_t v = 0; v < vertices; ++v)
        same_places_[v] = surfaces_.change().former[v] == former_[v] ? surfaces_.change().same_places[v] : 0;
}

void SceneVisibility::count_later_steps(double milliseconds) {
    if (progressive_) progressive_->count_later_steps(milliseconds);
}

BakeGeometry SceneVisibility::geometry_of(const SceneGeometry& surfaces, SurfaceRays& rays,
                                          std::span<const std::uint8_t> needed,
                                          const RenderOptions& options) {
    BakeGeometry geometry = bake_geometry(surfaces, rays, needed, options);
    geometry.possible_blockers = [this, geometry] {
        if (!possible_blockers_)
            possible_blockers_ = std::make_shared<const PossibleBlockers>(geometry, *directions_, true);
        return possible_blockers_;
    };
    return geometry;
}

bool SceneVisibility::found_for(const BakedImages& images) const {
    if (!need_the_same(seen_from_, images.views)) return false;
    return !seen_.sampled ||
           (are_equal(seen_from_, images.views) && std::ranges::equal(seen_at_, images.samples));
}

bool SceneVisibility::bake(const SceneGeometry& surfaces, SurfaceRays& rays, const BakedImages& images,
                           const RenderOptions& options, Workers& workers, Progress& progress,
                           Statistics& statistics) {
    const ImageNeeds needs = images.needs;
    const int count = options.bake_directions;
    const glm::dmat3& axes = surfaces.own_axes();
    const SceneGeometry::Change& change = surfaces.change();
    const bool same = baking_.is_current(surfaces.version(), count, axes);
    // Before the search, which leaves outdated vertices out.
    if (!same && since_outdated_.changes() >= kMostChanges) outdated_.clear();
    const bool is_part = any(needed_) || any(outdated_);
    const bool carry = !change.kept.empty() && (needed_.empty() || is_part) &&
                       baking_.is_current(change.before, count, axes);
    NeededVertices needed;
    const bool part_is_current = same && (!needed_.empty() || shortest_edge_ > 0);
    bool searched = false;  // whether this is another view
    if (needs != ImageNeeds::all && (!same || part_is_current)) {
        searched = !found_for(images);
        if (searched) {
            seeing_.reset();
            if (part_is_current) ++views_since_;
        }
        // A search for a bake that takes over vertices has left those out of its sample.
        if (!same && !carry) seeing_.reset();
        seeing_.run(surfaces.version(), surfaces.material_version(), [&] {
            const std::size_t vertices = surfaces.geometry().positions.size();
            const std::vector<std::uint8_t> known = carry
                                                        ? carried_states(change, needed_, outdated_, vertices)
                                                    : same ? outdated_
                                                           : std::vector<std::uint8_t>();
            workers.run([&] {
                seen_ = needed_vertices(surfaces.geometry(), images.views, images.samples, rays, known);
            });
            seen_from_.assign(images.views.begin(), images.views.end());
            seen_at_.assign(images.samples.begin(), images.samples.end());
        });
        needed = seen_;
        if (shows_others(surfaces.geometry(), seen_.seen, images.lobes))
            needed = {.flags = {}, .seen = {}, .pixel = seen_.pixel};
    }
    bool rest = false;
    if (part_is_current) {
        const bool may_grow = grows();
        if (is_enough(needed) && (may_grow || !searched)) return false;
        if (!needed.seen.empty() && (is_part || needed_.empty()) && may_grow) {
            grow(surfaces, rays, needed, options, workers, progress, statistics);
            return grew_ = true;
        }
        rest = is_part;
        if (!needed_.empty()) baking_.reset();
    }
    if (shortest_edge_ > 0 && !carry && (rest || needed_.empty())) refine_all();
    const bool ran = baking_.run(surfaces.version(), count, axes, [&] {
        const Stopwatch watch;
        const bool has_points = rest && points_bake_ == baked_.version();
        carried_ = carry || rest ? baked_.version() : 0;
        baked_geometry_ = 0;
        find_directions(surfaces, options);
        const double share = options.refine_tolerance > 0 ? kTracingOfBake : 1;
        const auto report = [&](double fraction) { progress.report("bake", share * fraction); };
        BakeStatistics baked;
        std::vector<std::uint32_t> like;
        workers.run([&] {
            std::vector<std::uint8_t> room;
            BakeGeometry geometry =
                geometry_of(surfaces, rays, traced_of(surfaces.geometry(), needed.flags, room), options);
            Visibility visibility;
            if (carry) {
                visibility = bake_carried(geometry, surfaces, needed, options, report, baked);
            } else if (rest) {
                visibility = bake_rest(geometry, surfaces, report, baked);
                needed = {};
            } else {
                if (needed.pixel > 0 && !geometry.every_ray)
                    geometry.like = like =
                        vertices_in_pixels(surfaces.geometry(), needed.flags, needed.pixel);
                visibility = load_or_bake(geometry, *directions_, folder_, notice_, report, &baked);
            }
            baked_.change() = std::make_shared<const Visibility>(std::move(visibility));
        });
        if (has_points) points_bake_ = baked_.version();
        if (!carry) {
            outdated_.clear();
            needed_ = baked_vertices(std::move(needed.flags), like);
            wanted_ = std::move(needed.seen);
            traced_edge_ = shortest_edge_ = kPixelsOfEdge * needed.pixel;
        }
        views_since_ = 0;
        baked_geometry_ = surfaces.version();
        count_bake(baked, watch, statistics);
    });
    return ran && (carry || rest);
}

}  // namespace nicol
