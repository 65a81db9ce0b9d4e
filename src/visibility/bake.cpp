// SPDX-License-Identifier: MIT
#include "visibility/bake.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <deque>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "geometry/ray_scene.hpp"
#include "progress.hpp"
#include "visibility/agreeing_neighbours.hpp"
#include "visibility/bake_origins.hpp"
#include "visibility/possible_blockers.hpp"
#include "visibility/vertex_rays.hpp"

namespace nicol {
namespace {

// Part of all vertices that is few, as its inverse: preparing to spare their rays takes longer than they do.
// The second is that of a bake that knows no rays, in which all rays of these vertices are traced.
constexpr std::size_t kFew = 4;
constexpr std::size_t kFewNeeded = 64;

// Number of rays between two calls of the progress callback.
constexpr std::size_t kRaysAtATime = std::size_t{1} << 21;

std::vector<glm::vec3> unit_normals(std::span<const glm::vec3> normals) {
    std::vector<glm::vec3> out;
    out.reserve(normals.size());
    for (std::size_t v = 0; v < normals.size(); ++v) {
        // Double precision is needed because squares of floats may vanish or overflow.
        const glm::dvec3 normal(normals[v]);
        const double length = glm::length(normal);
        if (!(length > 0) || !std::isfinite(length)) {
            refuse("the normal of vertex " + std::to_string(v) +
                   (length == 0 ? " is zero" : " is not finite") +
                   "; a vertex needs one to have a front side");
        }
        out.emplace_back(normal / length);
    }
    return out;
}

// Place in the list of a former bake for vertices that were not in it.
constexpr std::size_t kNone = ~std::size_t{0};

/// Vertices of a former bake, and their rays whose result may differ.
class KnownRays {
public:
    KnownRays(const FormerBake& former, const BakeGeometry& geometry, const DirectionSet& directions,
              std::size_t vertices)
        : former_(former), places_(vertices, kNone), disturbed_of_(vertices, 0) {
        disturbed_.emplace_back(directions, former.disturbances);
        for (const VertexRun& run : former.kept) add(run, Known::former);
        for (const ShiftedObject& shifted : former.shifted) {
            disturbed_.emplace_back(directions, shifted.others);
            add(shifted.vertices, Known::former);
        }
        if (std::ranges::find(former.known, Known::earlier) == former.known.end()) return;
        // Vertices that are not needed keep their bits, whatever disturbs their rays.
        if (needs_earlier(former, geometry)) disturbed_.emplace_back(directions, former.earlier);
        for (const VertexRun& run : former.kept) add(run, Known::earlier);
    }

    [[nodiscard]] bool knows(std::size_t v) const { return places_[v] != kNone; }
    /// Gives a known vertex its former bits.
    void keep(std::size_t v, Visibility& visibility) const {
        visibility.take(v, former_.visibility, places_[v]);
    }
    /// Returns the former bits of a known vertex. bundles: room for its disturbed rays. `disturbed` of the
    /// result is null if there are none.
    [[nodiscard]] FormerBits of(std::size_t v, const glm::vec3& origin, const glm::vec3& normal,
                                DisturbedBundles& bundles) const {
        const bool any = disturbed_[disturbed_of_[v]].find(origin, normal, bundles);
        return {.bits = former_.visibility.at(places_[v]),
                .disturbed = any ? &bundles : nullptr,
                .unoccluded = former_.visibility.unoccluded(places_[v])};
    }

private:
    // Returns whether a vertex is needed that is known from before earlier changes. former: has such vertices
    // and its runs are valid.
    [[nodiscard]] static bool needs_earlier(const FormerBake& former, const BakeGeometry& geometry) {
        return std::ranges::any_of(former.kept, [&](const VertexRun& run) {
            for (std::size_t v = run.first; v < run.last; ++v)
                if (former.known[run.before + (v - run.first)] == Known::earlier && geometry.needs(v))
                    return true;
            return false;
        });
    }
    // Adds the vertices of a run in this state. disturbed_.back() finds the rays of those that are needed.
    void add(const VertexRun& run, Known state) {
        const std::size_t there = run.last - std::min(run.first, run.last) + run.before;
        if (run.first > run.last || run.last > places_.size() || there > former_.visibility.vertices()) {
            refuse("vertices " + std::to_string(run.first) + " to " + std::to_string(run.last) +
                   " are not all in both bakes");
        }
        for (std::size_t v = run.first; v < run.last; ++v) {
            const std::size_t before = run.before + (v - run.first);
            if ((former_.known.empty() ? Known::former : former_.known[before]) != state) continue;
            places_[v] = before;
            disturbed_of_[v] = static_cast<std::uint32_t>(disturbed_.size() - 1);
        }
    }

    const FormerBake& former_;
    std::vector<std::size_t> places_;  // index in the former bake, or kNone
    std::deque<DisturbedRays> disturbed_;
    std::vector<std::uint32_t> disturbed_of_;
};

// Returns whether few of the vertices are needed and not known. known: null if no rays are known.
bool few_needed(const BakeGeometry& geometry, std::size_t vertices, const KnownRays* known) {
    std::size_t count = 0;
    for (std::size_t v = 0; v < vertices; ++v)
        count += geometry.needs(v) && (known == nullptr || !known->knows(v)) ? 1 : 0;
    return (known == nullptr ? kFewNeeded : kFew) * count < vertices;
}

}  // namespace

BakeRays rays_of(const BakeGeometry& geometry) {
    if (geometry.rays) return {.blockers = geometry.rays(), .glass = geometry.glass};
    const RaySurface surface{.positions = geometry.positions,
                             .triangles = geometry.blocking.empty() ? geometry.triangles : geometry.blocking,
                             .present = geometry.present};
    return {.blockers = std::make_shared<const RayScene>(std::span(&surface, 1)), .glass = geometry.glass};
}

Visibility bake(const BakeGeometry& geometry, const DirectionSet& directions, const BakeProgress& progress,
                BakeStatistics* statistics, const FormerBake* former) {
    const std::size_t vertices = geometry.positions.size();
    if (geometry.normals.size() != vertices) {
        refuse(std::to_string(geometry.normals.size()) + " normals for " + std::to_string(vertices) +
               " vertices; there must be one for each");
    }
    if (former != nullptr && former->visibility.directions() != directions.size()) {
        refuse("the former bake has " + std::to_string(former->visibility.directions()) +
               " directions and this one " + std::to_string(directions.size()) + "; they must be the same");
    }
    const std::vector<glm::vec3> normals = unit_normals(geometry.normals);
    const auto report = [&](std::size_t traced) {
        if (progress)
            progress(static_cast<double>(traced) / static_cast<double>(std::max<std::size_t>(vertices, 1)));
    };

    report(0);
    const Stopwatch building;
    const BakeRays scene = rays_of(geometry);
    const std::vector<glm::vec3> origins = bake_origins(geometry, normals);
    std::optional<KnownRays> known_rays;
    if (former != nullptr) known_rays.emplace(*former, geometry, directions, vertices);
    const bool few = few_needed(geometry, vertices, known_rays ? &*known_rays : nullptr);
    const bool spare = !geometry.every_ray && !few;
    const std::shared_ptr<const PossibleBlockers> possible =
        possible_blockers_of(geometry, directions, spare);
    const PossibleBlockers& blockers = *possible;
    const AgreeingNeighbours agreeing(geometry, normals, spare);
    const double build_milliseconds = building.milliseconds();

    const Stopwatch tracing;
    Visibility visibility(directions.size(), vertices);
    std::atomic<std::uint64_t> rays = 0;
    std::atomic<std::uint64_t> skipped = 0;
    std::atomic<std::uint64_t> from = 0;
    struct Scratch {
        DisturbedBundles bundles;
        Agreement agreement;
        std::vector<FlatBlockers::Cone> faces;
    };
    const auto trace = [&](std::uint32_t v, Scratch& scratch) -> RayCounts {
        if (known_rays && known_rays->knows(v)) {
            const FormerBits known = known_rays->of(v, origins[v], normals[v], scratch.bundles);
            if (known.disturbed == nullptr) {
                known_rays->keep(v, visibility);
                return {};
            }
            blockers.flat().find(origins[v], normals[v], scratch.faces);
            return trace_vertex(scene, directions, origins[v], normals[v], v, known, scratch.faces,
                                visibility);
        }
        Agreement& agreement = scratch.agreement;
        if (!agreeing.find(v, directions, visibility, agreement))
            return blockers.trace(scene, origins[v], normals[v], v, {}, visibility);
        blockers.flat().find(origins[v], normals[v], scratch.faces);
        return agreement.settle(visibility.at(v), blockers.cones(), [&](const FormerBits& known) {
            return trace_vertex(scene, directions, origins[v], normals[v], v, known, scratch.faces,
                                visibility);
        });
    };
    if (!geometry.needed_alone)
        tbb::parallel_for(std::size_t{0}, vertices, [&](std::size_t v) {
            if (geometry.needs(v)) return;
            if (known_rays && known_rays->knows(v))
                known_rays->keep(v, visibility);
            else
                set_open(directions, normals[v], v, visibility);
        });
    std::size_t done = 0;
    const std::size_t chunk = 2 * kRaysAtATime / directions.size();
    for (const std::vector<std::uint32_t>& turn : agreeing.turns())
        for (std::size_t first = 0; first < turn.size(); first += chunk) {
            const std::size_t last = std::min(first + chunk, turn.size());
            tbb::parallel_for(tbb::blocked_range<std::size_t>(first, last, 4), [&](const auto& range) {
                RayCounts sum;
                std::uint64_t tracing = 0;
                Scratch scratch;
                for (std::size_t i = range.begin(); i < range.end(); ++i) {
                    const RayCounts of_vertex = trace(turn[i], scratch);
                    sum.traced += of_vertex.traced;
                    sum.skipped += of_vertex.skipped;
                    tracing += of_vertex.traced + of_vertex.skipped > 0 ? 1 : 0;
                }
                rays += sum.traced;
                skipped += sum.skipped;
                from += tracing;
            });
            done += last - first;
            report(done);
        }
    if (statistics != nullptr) {
        *statistics = {.rays = rays,
                       .rays_skipped = skipped,
                       .vertices = from,
                       .milliseconds = tracing.milliseconds(),
                       .build_milliseconds = build_milliseconds,
                       .unoccluded = visibility.unoccluded_count(),
                       .from_cache = false};
    }
    return visibility;
}

}  // namespace nicol
