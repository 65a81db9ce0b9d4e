// SPDX-License-Identifier: MIT
#include "render/progressive_bake.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <utility>

#include "geometry/unit.hpp"
#include "render/bake_order.hpp"
#include "render/paired_vertices.hpp"
#include "surfaces/carried_refinement.hpp"
#include "visibility/turned_directions.hpp"
#include "visibility/vertex_rays.hpp"

namespace nicol {
namespace {

constexpr std::size_t kVerticesAtATime = 128;
constexpr std::size_t kPointsAtATime = 64;

}  // namespace

void ProgressiveBake::begin(Baked given) {
    surfaces_ = given.surfaces;
    axes_ = given.axes;
    given_ = given.given;
    topology_ = std::move(given.topology);
    refined_ = std::move(given.refined);
    parts_ = std::move(given.parts);
    numbers_ = std::move(given.numbers);
    visible_ = std::move(given.visibility);
    points_ = std::move(given.points);
    tolerance_ = given.tolerance;
    most_vertices_ = given.most_vertices;
    unoccluded_.assign(visible_.unoccluded().begin(), visible_.unoccluded().end());
    states_.assign(visible_.vertices(), state_);
    waits_.assign(visible_.vertices(), 0);
    for (std::size_t v = 0; v < given.baked.size(); ++v)
        if (given.baked[v] == 0) states_[v] = 0;
    lagging_.assign(given.lagging.begin(), given.lagging.end());
    used_normals_.reset(given.normals);
    finished_ = given.baked.empty() && given.fine;
    pending_ = finished_ ? 0 : states_.size();
}

void ProgressiveBake::follow(const Input& input) {
    const bool same_scene = surfaces_ == input.surfaces.version() && axes_ == input.axes;
    const bool same_refinement =
        tolerance_ == input.options.refine_tolerance && most_vertices_ == input.options.max_vertices;
    tolerance_ = input.options.refine_tolerance;
    most_vertices_ = input.options.max_vertices;
    any_changed_ = false;
    changed_ = 0;
    if (same_scene) {
        former_.resize(visible_.vertices());
        std::iota(former_.begin(), former_.end(), 0U);
        same_normals_.assign(former_.size(), 1);
        if (!same_refinement) {
            refinement_.reset();
            finished_ = false;
        }
        if (pending_ > 0 && order_.empty()) find_order(input);  // of a bake that begin() was given
    } else {
        follow_geometry(input);
        find_order(input);
    }
    for (std::uint32_t& before : former_)
        if (!lagging_.empty() && before != kNoVertex && lagging_[before] != 0) before = kNoVertex;
    any_changed_ = any_changed_ || !lagging_.empty();
    lagging_.clear();
    if (std::exchange(unpublished_, true)) {
        std::ranges::fill(former_, kNoVertex);
        used_normals_.reset(geometry(input).normals);
        any_changed_ = true;
    }
}

void ProgressiveBake::follow_geometry(const Input& input) {
    const SceneGeometry::Change& change = input.surfaces.change();
    const WorldGeometry& geometry = input.surfaces.geometry();
    const bool follows = surfaces_ != 0 && surfaces_ == change.before && axes_ == input.axes;
    refinement_.reset();
    rays_ = {};
    finished_ = false;
    any_changed_ = true;
    origins_.clear();
    CarriedRefinement next;
    if (follows) {
        next = carried(topology_, given_, input.surfaces);
        if (pending_ == 0) all_ = {};
        last_ = {};
        last_.add(change.added, change.removed);
        all_.add(change.added, change.removed);
        for_points_.add(change.added, change.removed);
    } else {
        next.former.assign(geometry.positions.size(), kNoVertex);
        next.moved = next.former;
        points_ = {};
        for_points_ = {};
    }
    surfaces_ = input.surfaces.version();
    axes_ = input.axes;
    given_ = geometry.positions.size();
    ++state_;

    const VertexNumbers numbers_before = std::exchange(numbers_, {});
    parts_.clear();
    refined_.reset();
    topology_ = std::move(next.refinement);
    if (!topology_.parents.empty()) split(geometry, topology_);
    take_over(input, next.former, next.moved, numbers_before);
}

Visibility ProgressiveBake::split(const WorldGeometry& geometry, const Refinement& refinement) {
    RefinedGeometry split = nicol::refined(geometry, refinement, most_vertices_);
    refined_ = std::make_shared<WorldGeometry>(std::move(split.geometry));
    parts_ = std::move(split.parts);
    numbers_ = std::move(split.numbers);
    return std::move(split.visibility);
}

void ProgressiveBake::take_over(const Input& input, std::span<const std::uint32_t> former,
                                std::span<const std::uint32_t> moved, const VertexNumbers& numbers_before) {
    const std::size_t vertices = refined_ ? refined_->positions.size() : former.size();
    const std::size_t directions = input.directions.size();
    std::vector<TurnedDirections> turned;
    std::vector<std::uint32_t> turned_of;
    const std::vector<SceneGeometry::MovedRun>& runs = input.surfaces.change().moved;
    for (const SceneGeometry::MovedRun& run : runs) {
        turned_of.push_back(run.rotation == glm::dmat3(1.0) ? kNoVertex
                                                            : static_cast<std::uint32_t>(turned.size()));
        if (turned_of.back() != kNoVertex) turned.emplace_back(input.directions, run.rotation);
    }
    former_.assign(vertices, kNoVertex);
    bool in_place = visible_.vertices() == vertices && visible_.directions() == directions;
    for (std::uint32_t v = 0; v < vertices; ++v) {
        const std::uint32_t i = numbers_.source(v);
        if (former[i] == kNoVertex) {
            in_place = false;
            continue;
        }
        former_[v] =
            numbers_.is_copy(v) ? numbers_before.next_copy(former_[v - 1]) : numbers_before.number(former[i]);
        in_place = in_place && former_[v] == v;
    }
    Visibility last;
    std::vector<std::uint32_t> last_states;
    std::vector<std::uint8_t> last_unoccluded, last_waits;
    if (!in_place) {
        last = std::exchange(visible_, Visibility(directions, vertices));
        last_states = std::exchange(states_, std::vector<std::uint32_t>(vertices, 0));
        last_waits = std::exchange(waits_, std::vector<std::uint8_t>(vertices, kLongestWait));
        last_unoccluded = std::exchange(unoccluded_, std::vector<std::uint8_t>(vertices, 1));
    }
    tbb::parallel_for(std::size_t{0}, vertices, [&](std::size_t v) {
        const std::uint32_t i = numbers_.source(v);
        const std::uint32_t before = former_[v];
        const std::span bits = visible_.at(v);
        if (before == kNoVertex) {
            std::ranges::fill(bits, ~std::uint64_t{0});
            visible_.set_unoccluded(v, true);
            return;
        }
        if (!in_place) {
            visible_.take(v, last, before);
            states_[v] = last_states[before];
            unoccluded_[v] = last_unoccluded[before];
            waits_[v] = last_waits[before];
        }
        if (waits_[v] < kLongestWait) ++waits_[v];
        if (moved[i] == kNoVertex) return;
        states_[v] = 0;
        const std::uint32_t turn = turned_of[moved[i]];
        if (turn == kNoVertex) return;
        former_[v] = kNoVertex;  // its normal has turned
        if (unoccluded_[v] != 0) return;
        const std::vector<std::uint64_t> unturned(bits.begin(), bits.end());
        turned[turn].turn(unturned, bits);
    });
    const auto deformed = [&](std::uint32_t v) {
        const std::uint32_t run = moved[numbers_.source(v)];
        return run != kNoVertex && runs[run].deformed;
    };
    same_normals_ = used_normals_.follow(geometry(input).normals, former_, deformed);
    pending_ = vertices;
}

void ProgressiveBake::find_order(const Input& input) {
    const WorldGeometry& geometry = this->geometry(input);
    std::vector<float> parts(states_.size(), 1.0F);
    const Disturbances change = last_.disturbances();
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t v) {
        if (states_[v] != 0) parts[v] = part_of_sky(geometry.positions[v], change);
    });
    order_ = bake_order(geometry, input.views, parts, waits_);
    next_ = 0;
}

void ProgressiveBake::find_origins(const Input& input) {
    const WorldGeometry& geometry = input.surfaces.geometry();
    const std::vector<glm::vec3>& origins = given_origins_.of(input.surfaces);
    if (!refined_) {
        origins_ = origins;
        return;
    }
    std::vector<glm::vec3> shifts;
    shifts.reserve(given_ + topology_.parents.size());
    for (std::size_t v = 0; v < given_; ++v) shifts.push_back(origins[v] - geometry.positions[v]);
    for (const glm::uvec2& pair : topology_.parents)
        shifts.push_back(0.5F * shifts[pair.x] + 0.5F * shifts[pair.y]);
    origins_.resize(refined_->positions.size());
    for (std::size_t v = 0; v < origins_.size(); ++v) {
        const std::uint32_t i = numbers_.source(v);
        origins_[v] = i < given_ ? origins[i] : refined_->positions[v] + shifts[i];
    }
}

void ProgressiveBake::trace(const Input& input, std::span<const std::uint32_t> vertices,
                            const DisturbedRays& since_last, const DisturbedRays& since_all,
                            BakeStatistics& statistics) {
    const WorldGeometry& geometry = this->geometry(input);
    std::atomic<std::uint64_t> rays = 0, traced = 0, changed = 0;
    tbb::parallel_for(std::size_t{0}, vertices.size(), [&](std::size_t i) {
        const std::uint32_t v = vertices[i];
        const std::uint32_t state = states_[v];
        if (state == state_) return;  // an earlier call traced it, which ended with an exception
        if (!receivers_.empty() && receivers_[v] == 0) {
            states_[v] = state_;
            return;
        }
        const glm::vec3 normal = unit(geometry.normals[v]);
        DisturbedBundles bundles;
        if (state != 0) {
            const DisturbedRays& disturbed = state + 1 == state_ ? since_last : since_all;
            if (!disturbed.find(origins_[v], normal, bundles)) {
                states_[v] = state_;
                waits_[v] = 0;
                return;
            }
        }
        const std::span bits = visible_.at(v);
        const std::vector<std::uint64_t> before(bits.begin(), bits.end());
        std::optional<FormerBits> known;
        if (state != 0) known = FormerBits{before, &bundles, unoccluded_[v] != 0};
        const bool was_unoccluded = visible_.unoccluded(v);
        std::ranges::fill(bits, 0U);
        const std::uint64_t count =
            trace_vertex(rays_, input.directions, origins_[v], normal, v, known, {}, visible_).traced;
        states_[v] = state_;
        waits_[v] = 0;
        unoccluded_[v] = visible_.unoccluded(v) ? 1 : 0;
        visible_.set_unoccluded(v, was_unoccluded && visible_.unoccluded(v));
        rays += count;
        traced += count > 0 ? 1 : 0;
        const bool same = was_unoccluded ? visible_.unoccluded(v) : std::ranges::equal(before, bits);
        if (same && !used_normals_.turned(v, geometry.normals[v])) return;
        former_[v] = kNoVertex;
        used_normals_.use(v, geometry.normals[v]);
        ++changed;
    });
    statistics.rays += rays;
    statistics.vertices += traced;
    changed_ += changed;
    any_changed_ = any_changed_ || changed > 0;
}

void ProgressiveBake::advance(const Input& input, SurfaceRays& rays, double milliseconds, Workers& workers,
                              Progress& progress, BakeStatistics& statistics) {
    const Stopwatch watch;
    const auto spent = [&] { return watch.milliseconds() + static_cast<double>(changed_) * later_ms_; };
    std::vector<std::uint32_t> vertices;
    std::optional<DisturbedRays> since_last, since_all;
    bool first = true;
    if (!rays_.blockers) rays_ = {.blockers = rays.get(), .glass = rays.glass()};
    for (; next_ < order_.size() && (first || spent() < milliseconds); first = false) {
        progress.report("bake",
                        kTracingOfBake * static_cast<double>(next_) / static_cast<double>(order_.size()));
        vertices.clear();
        std::size_t end_of_step = next_;
        for (; end_of_step < order_.size() && vertices.size() < kVerticesAtATime; ++end_of_step) {
            const std::uint32_t begin = order_[end_of_step] * static_cast<std::uint32_t>(kLanes);
            const std::uint32_t end = std::min(begin + static_cast<std::uint32_t>(kLanes),
                                               static_cast<std::uint32_t>(states_.size()));
            for (std::uint32_t v = begin; v < end; ++v) vertices.push_back(v);
        }
        workers.run([&] {
            if (origins_.empty()) {
                find_origins(input);
                receivers_ = receivers_of(refined_ ? *refined_ : input.surfaces.geometry());
            }
            if (!since_last) {
                since_last.emplace(input.directions, last_.disturbances());
                since_all.emplace(input.directions, all_.disturbances());
            }
            trace(input, vertices, *since_last, *since_all, statistics);
        });
        next_ = end_of_step;
        pending_ -= vertices.size();
    }
    if (next_ < order_.size() || finished_) return;
    pending_ = 0;
    while (!finished_ && (first || spent() < milliseconds)) {
        const double refined = refinement_ ? refinement_->fraction() : 0;
        progress.report("bake", kTracingOfBake + (1 - kTracingOfBake) * refined);
        first = false;
        workers.run([&] {
            // After an exception, the refinement begins anew.
            std::unique_ptr<StepwiseRefinement> refinement = std::move(refinement_);
            if (!refinement)
                begin_refinement(input);
            else if (refinement->step(kPointsAtATime))
                refinement_ = std::move(refinement);
            else
                end_refinement(input, refinement->result(statistics));
        });
    }
}

void ProgressiveBake::begin_refinement(const Input& input) {
    std::vector<std::uint32_t> given(given_);
    for (std::size_t i = 0; i < given_; ++i) given[i] = numbers_.number(i);
    refining_visibility_ = visible_.selected(given);
    for (std::size_t i = 0; i < given_; ++i)
        refining_visibility_.set_unoccluded(i, unoccluded_[given[i]] != 0);
    refining_ = input.surfaces.shared_geometry();
    refining_receivers_ = receivers_of(*refining_);
    const RefineOptions wanted{.tolerance = tolerance_, .max_vertices = most_vertices_};
    if (!(tolerance_ > 0) || !can_refine(refining_visibility_, wanted)) return end_refinement(input, {});
    former_points_ = std::make_unique<FormerRefinement>(
        FormerRefinement{.points = points_, .disturbances = for_points_.disturbances()});
    refinement_ = std::make_unique<StepwiseRefinement>(BakeGeometry{.positions = refining_->positions,
                                                                    .normals = refining_->normals,
                                                                    .triangles = refining_->triangles,
                                                                    .present = presence_of(*refining_),
                                                                    .glass = rays_.glass,
                                                                    .rays = [this] { return rays_.blockers; },
                                                                    .needed = refining_receivers_},
                                                       input.directions, refining_visibility_, wanted,
                                                       points_.size() > 0 ? former_points_.get() : nullptr);
}

void ProgressiveBake::end_refinement(const Input& input, Refinement next) {
    refinement_.reset();
    points_ = std::move(next.points);
    for_points_ = {};
    // A point takes less memory than a vertex, for which the limit leaves room.
    if (given_ + next.parents.size() + points_.size() > most_vertices_) points_ = {};
    const VertexNumbers numbers_before = std::exchange(numbers_, {});
    const std::shared_ptr<WorldGeometry> refined_before = std::exchange(refined_, nullptr);
    const Visibility last = std::exchange(visible_, std::move(refining_visibility_));
    const std::vector<std::uint32_t> former = std::move(former_);
    const std::size_t added_before = topology_.parents.size();
    parts_.clear();
    if (!next.parents.empty()) visible_ = split(*refining_, next);
    next.visibility = {};
    next.points = {};
    topology_ = std::move(next);
    const std::vector<std::uint32_t> before =
        paired_vertices(given_, {refined_before.get(), numbers_before, added_before, last},
                        {refined_.get(), numbers_, topology_.parents.size(), visible_});
    former_.assign(visible_.vertices(), kNoVertex);
    const std::vector<std::uint8_t> same_normals = std::exchange(same_normals_, {});
    same_normals_.assign(visible_.vertices(), 1);
    for (std::uint32_t v = 0; v < former_.size(); ++v) {
        if (before[v] == kNoVertex) continue;
        former_[v] = former[before[v]];
        same_normals_[v] = same_normals[before[v]];
    }
    used_normals_.reset(geometry(input).normals);
    any_changed_ = true;
    unoccluded_.assign(visible_.unoccluded().begin(), visible_.unoccluded().end());
    finish(input);
}

void ProgressiveBake::finish(const Input& input) {
    const bool shadow_all = (input.options.disabled_optimisations & skip_unoccluded) != 0;
    for (std::size_t v = 0; v < visible_.vertices(); ++v)
        visible_.set_unoccluded(v, unoccluded_[v] != 0 && !shadow_all);
    states_.assign(visible_.vertices(), state_);
    waits_.assign(visible_.vertices(), 0);
    origins_.clear();
    order_.clear();
    last_ = all_ = {};
    refining_visibility_ = {};
    rays_ = {};
    refining_.reset();
    finished_ = true;
}

void ProgressiveBake::count_later_steps(double milliseconds) {
    // Fewer vertices would say more of what every frame costs.
    if (changed_ < kVerticesAtATime) return;
    later_ms_ = (later_ms_ + milliseconds / static_cast<double>(changed_)) / 2;
    changed_ = 0;
}

}  // namespace nicol
