// SPDX-License-Identifier: MIT
// Bakes that take over what a change of the scene has left.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "render/bake_inputs.hpp"
#include "render/baked_vertices.hpp"
#include "render/carried_states.hpp"
#include "render/scene_visibility.hpp"
#include "render/shifted_objects.hpp"

namespace nicol {
namespace {

std::vector<std::uint8_t> carried_flags(std::span<const VertexRun> runs, std::span<const std::uint8_t> flags,
                                        std::size_t vertices) {
    std::vector<std::uint8_t> out(vertices, 0);
    for (const VertexRun& run : runs)
        std::copy_n(flags.begin() + static_cast<std::ptrdiff_t>(run.before), run.last - run.first,
                    out.begin() + static_cast<std::ptrdiff_t>(run.first));
    return out;
}

}  // namespace

std::vector<std::uint8_t> carried_states(const SceneGeometry::Change& change,
                                         std::span<const std::uint8_t> before,
                                         std::span<const std::uint8_t> outdated, std::size_t vertices) {
    std::vector<std::uint8_t> out(vertices, 0);
    const auto state = [&](std::size_t v) { return before.empty() ? kTraced : before[v]; };
    for (const VertexRun& run : change.kept)
        for (std::size_t v = run.first; v < run.last; ++v) {
            const std::size_t former = run.before + (v - run.first);
            out[v] = state(former);
            if (out[v] == 0 && !outdated.empty()) out[v] = outdated[former];
        }
    for (const SceneGeometry::MovedRun& moved : change.moved) {
        if (!moved.others) continue;
        for (std::size_t v = moved.vertices.first; v < moved.vertices.last; ++v)
            out[v] = state(moved.vertices.before + (v - moved.vertices.first));
    }
    return out;
}

std::vector<std::uint8_t> SceneVisibility::outdated(bool shared) const {
    std::vector<std::uint8_t> out = outdated_;
    for (std::uint8_t& state : out)
        if (!shared && state != kTraced) state = 0;
    return out;
}

Visibility SceneVisibility::bake_carried(BakeGeometry geometry, const SceneGeometry& surfaces,
                                         NeededVertices& needed, const RenderOptions& options,
                                         const BakeProgress& report, BakeStatistics& baked) {
    const SceneGeometry::Change& change = surfaces.change();
    const std::size_t vertices = surfaces.geometry().positions.size();
    const std::size_t before = (*baked_)->vertices();
    const double edge = kPixelsOfEdge * needed.pixel;
    // Images that need all vertices whatever they show need shadows of any detail, too.
    const bool finest = needed.flags.empty() && edge == 0;
    const bool shared = finest ? shortest_edge_ == 0 : edge == 0 || shares(edge);
    const auto useful = [shared](std::uint8_t state) { return state == kTraced || (shared && state != 0); };

    std::vector<Known> known(before, Known::former);
    for (std::size_t v = 0; v < needed_.size(); ++v)
        if (!useful(needed_[v]))
            known[v] = !outdated_.empty() && useful(outdated_[v]) ? Known::earlier : Known::nothing;
    if (!any(outdated_)) since_outdated_ = {};
    since_outdated_.add(change.added, change.removed);

    std::vector<std::uint8_t> states = carried_states(change, needed_, outdated_, vertices);
    std::vector<std::uint8_t> missing(vertices, 0);
    for (std::size_t v = 0; v < vertices; ++v) {
        if (!useful(states[v])) states[v] = 0;
        missing[v] = (needed.flags.empty() || needed.flags[v] != 0) && states[v] == 0 ? 1 : 0;
    }
    std::vector<std::uint32_t> like;
    const double pixel = shared_pixel(needed.pixel);
    if (pixel > 0 && !finest && !geometry.every_ray)
        geometry.like = like = vertices_in_pixels(surfaces.geometry(), missing, pixel);
    const std::vector<ShiftedObject> shifted = shifted_objects(change, traces_all(options));
    const FormerBake former{.visibility = **baked_,
                            .kept = change.kept,
                            .disturbances = {change.added, change.removed},
                            .shifted = shifted,
                            .known = known,
                            .earlier = since_outdated_.disturbances()};
    Visibility visibility = nicol::bake(geometry, *directions_, report, &baked, &former);

    missing = baked_vertices(std::move(missing), like);
    std::vector<std::uint8_t> kept(vertices, 0);
    for (const VertexRun& run : change.kept)
        std::fill(kept.begin() + static_cast<std::ptrdiff_t>(run.first),
                  kept.begin() + static_cast<std::ptrdiff_t>(run.last), std::uint8_t{1});
    std::vector<std::uint8_t> outdated(vertices, 0);
    for (std::size_t v = 0; v < vertices; ++v) {
        if (missing[v] != 0) {
            states[v] = missing[v];
        } else if (!needed.flags.empty() && needed.flags[v] == 0) {
            outdated[v] = kept[v] != 0 ? states[v] : std::uint8_t{0};
            states[v] = 0;
        }
    }
    if (!wanted_.empty() && !needed.seen.empty()) {
        wanted_ = carried_flags(change.kept, wanted_, vertices);
        for (std::size_t v = 0; v < vertices; ++v) wanted_[v] |= needed.seen[v];
    } else if (needed.seen.empty()) {
        wanted_.clear();
    }
    if (finest && shortest_edge_ > 0)
        refine_all();
    else if (edge > 0)
        come_nearer(edge);
    const bool all = std::ranges::all_of(states, [](std::uint8_t state) { return state == kTraced; });
    needed_ = all ? std::vector<std::uint8_t>() : std::move(states);
    outdated_ = any(outdated) ? std::move(outdated) : std::vector<std::uint8_t>();
    return visibility;
}

}  // namespace nicol
