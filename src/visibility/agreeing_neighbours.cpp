// SPDX-License-Identifier: MIT
#include "visibility/agreeing_neighbours.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <glm/geometric.hpp>
#include <utility>

#include "geometry/welded_positions.hpp"
#include "simd/dispatch.hpp"
#include "visibility/bundle_bits.hpp"

namespace nicol {
namespace {

// Fewest vertices of a geometry worth the search. Coarse surfaces have details between their vertices.
constexpr std::size_t kFewestVertices = 4096;
// Turns after the first. Each leaves about a third of the points to the turns before.
constexpr std::size_t kLevels = 2;
// Neighbours that must be there, and those that must have a direction above their horizon.
constexpr std::size_t kFewestNeighbours = 3;
constexpr std::size_t kMostNeighbours = 8;
// Directions, half of them below the horizon, whose rays are traced although the neighbours agree. If they
// err in a part f of the directions, about exp(-32 f) of such vertices pass.
constexpr std::size_t kFewestChecks = 64;
// Part of the sample, as its inverse, that may differ before all rays are traced.
constexpr std::size_t kDiffering = 12;
// Sine of elevation of the lowest rays that are traced, with a margin.
constexpr float kLowestRay = 0x1p-16F;
constexpr float kFacingAlike = 0.5F;  // cosine between normals
constexpr float kSurrounded = 0.6F;   // largest length of the mean unit vector to neighbours
// Most nodes that a walk reaches; only where very many triangles meet there are more.
constexpr std::size_t kMostReached = 128;

/// Points and which of them lie beside each other: node n has the ends number first[n] to first[n + 1] - 1.
struct Graph {
    std::vector<std::uint32_t> points;  // of the nodes
    std::vector<std::size_t> first;
    std::vector<std::uint32_t> ends;  // nodes
};

// Calls visit(node) for the nodes that one or two edges lead to.
template <typename Visit>
void walk(const Graph& graph, std::uint32_t from, std::vector<std::uint32_t>& reached, const Visit& visit) {
    reached.assign(1, from);
    std::size_t begin = 0;
    for (int step = 0; step < 2; ++step) {
        const std::size_t end = reached.size();
        for (; begin < end; ++begin) {
            const std::uint32_t node = reached[begin];
            for (std::size_t i = graph.first[node]; i < graph.first[node + 1]; ++i) {
                // There are a few dozen nodes: a search is faster than a set.
                if (std::ranges::find(reached, graph.ends[i]) != reached.end()) continue;
                if (reached.size() == kMostReached) return;
                reached.push_back(graph.ends[i]);
                visit(graph.ends[i]);
            }
        }
    }
}

// Returns the graph of the edges of triangles between points. points: of the vertices.
Graph graph_of(std::span<const glm::uvec3> triangles, std::span<const std::uint32_t> point_of,
               std::vector<std::uint32_t> points) {
    std::vector<std::uint32_t> node_of(point_of.size(), kNoVertex);
    for (std::uint32_t n = 0; n < points.size(); ++n) node_of[points[n]] = n;
    const auto each_end = [&](const auto& visit) {
        for (const glm::uvec3& t : triangles)
            for (glm::length_t k = 0; k < 3; ++k) {
                const std::uint32_t a = node_of[point_of[t[k]]], b = node_of[point_of[t[(k + 1) % 3]]];
                if (a == b || a == kNoVertex || b == kNoVertex) continue;
                visit(a, b);
                visit(b, a);
            }
    };
    Graph graph{.points = std::move(points), .first = {}, .ends = {}};
    graph.first.assign(graph.points.size() + 1, 0);
    each_end([&](std::uint32_t from, std::uint32_t) { ++graph.first[from + 1]; });
    for (std::size_t n = 0; n < graph.points.size(); ++n) graph.first[n + 1] += graph.first[n];
    graph.ends.resize(graph.first.back());
    std::vector<std::size_t> place(graph.first.begin(), graph.first.end() - 1);
    each_end([&](std::uint32_t from, std::uint32_t to) { graph.ends[place[from]++] = to; });
    return graph;
}

// Returns 1 for nodes none of which lies beside another, while each other node lies beside one.
std::vector<std::uint8_t> chosen_nodes(const Graph& graph) {
    std::vector<std::uint8_t> chosen(graph.points.size(), 0), near(graph.points.size(), 0);
    for (std::uint32_t n = 0; n < chosen.size(); ++n) {
        if (near[n] != 0) continue;
        chosen[n] = 1;
        for (std::size_t i = graph.first[n]; i < graph.first[n + 1]; ++i) near[graph.ends[i]] = 1;
    }
    return chosen;
}

// Returns the graph of the chosen nodes, which are beside each other if at most two edges lie between.
Graph coarser(const Graph& graph, std::span<const std::uint8_t> chosen) {
    std::vector<std::uint32_t> node_of(graph.points.size(), kNoVertex);
    Graph out;
    for (std::uint32_t n = 0; n < chosen.size(); ++n) {
        if (chosen[n] == 0) continue;
        node_of[n] = static_cast<std::uint32_t>(out.points.size());
        out.points.push_back(graph.points[n]);
    }
    std::vector<std::uint32_t> reached;
    out.first.push_back(0);
    for (std::uint32_t n = 0; n < chosen.size(); ++n) {
        if (chosen[n] == 0) continue;
        walk(graph, n, reached, [&](std::uint32_t end) {
            if (chosen[end] != 0) out.ends.push_back(node_of[end]);
        });
        out.first.push_back(out.ends.size());
    }
    return out;
}

}  // namespace

AgreeingNeighbours::AgreeingNeighbours(const BakeGeometry& geometry, std::span<const glm::vec3> normals,
                                       bool find)
    : geometry_(geometry), normals_(normals) {
    const std::size_t vertices = geometry.positions.size();
    if (find && vertices >= kFewestVertices) {
        order();
        return;
    }
    turns_.resize(1);
    for (std::uint32_t v = 0; v < vertices; ++v)
        if (traced(v)) turns_[0].push_back(v);
    add_like();
}

bool AgreeingNeighbours::traced(std::uint32_t v) const {
    return geometry_.needs(v) && geometry_.like_of(v) == kNoVertex;
}

void AgreeingNeighbours::add_like() {
    std::vector<std::uint32_t> like;
    for (std::uint32_t v = 0; v < geometry_.like.size(); ++v)
        if (geometry_.needs(v) && geometry_.like_of(v) != kNoVertex) like.push_back(v);
    if (!like.empty()) turns_.push_back(std::move(like));
}

void AgreeingNeighbours::order() {
    const auto vertices = static_cast<std::uint32_t>(geometry_.positions.size());
    point_of_ = welded_positions(geometry_.positions);
    next_.assign(vertices, kNoVertex);
    first_.assign(vertices, 0);
    count_.assign(vertices, 0);
    std::vector<std::uint8_t> wanted(vertices, 0);
    for (std::uint32_t v = 0; v < vertices; ++v) {
        const std::uint32_t point = point_of_[v];
        if (traced(v)) wanted[point] = 1;
        if (v != point) next_[v] = std::exchange(next_[point], v);
    }
    // Surfaces stay connected where vertices take what others see.
    std::vector<std::uint32_t> merged = point_of_;
    for (std::uint32_t v = 0; v < vertices; ++v)
        if (geometry_.like_of(v) != kNoVertex) merged[v] = point_of_[geometry_.like_of(v)];
    std::vector<std::uint32_t> points;
    for (std::uint32_t p = 0; p < vertices; ++p)
        if (wanted[p] != 0) points.push_back(p);

    Graph graph = graph_of(geometry_.triangles, merged, std::move(points));
    std::vector<std::uint8_t> turn(vertices, 0);
    std::vector<std::uint32_t> reached;
    for (std::size_t level = kLevels; level > 0; --level) {
        const std::vector<std::uint8_t> chosen = chosen_nodes(graph);
        for (std::uint32_t n = 0; n < chosen.size(); ++n) {
            if (chosen[n] != 0) continue;
            const std::uint32_t point = graph.points[n];
            turn[point] = static_cast<std::uint8_t>(level);
            first_[point] = around_.size();
            walk(graph, n, reached, [&](std::uint32_t end) {
                if (chosen[end] == 0 || count_[point] == kMostNeighbours) return;
                around_.push_back(graph.points[end]);
                ++count_[point];
            });
        }
        graph = coarser(graph, chosen);
    }
    turns_.resize(kLevels + 1);
    for (std::uint32_t v = 0; v < vertices; ++v)
        if (traced(v)) turns_[turn[point_of_[v]]].push_back(v);
    add_like();
}

void AgreeingNeighbours::find_around(std::uint32_t vertex, std::vector<std::uint32_t>& out) const {
    out.clear();
    if (point_of_.empty()) return;
    glm::vec3 sum(0);
    const std::uint32_t point = point_of_[vertex];
    for (std::size_t i = first_[point]; i < first_[point] + count_[point]; ++i) {
        // Vertices at one position differ in their normals.
        std::uint32_t best = kNoVertex;
        float most = kFacingAlike;
        for (std::uint32_t v = around_[i]; v != kNoVertex; v = next_[v]) {
            const float facing = traced(v) ? glm::dot(normals_[v], normals_[vertex]) : 0;
            if (!(facing > most)) continue;
            most = facing;
            best = v;
        }
        if (best == kNoVertex) continue;
        out.push_back(best);
        sum += glm::normalize(geometry_.positions[best] - geometry_.positions[vertex]);
    }
    if (out.size() < kFewestNeighbours || !(glm::length(sum) <= kSurrounded * static_cast<float>(out.size())))
        out.clear();
}

bool AgreeingNeighbours::find(std::uint32_t vertex, const DirectionSet& directions,
                              const Visibility& visibility, Agreement& out) const {
    std::vector<std::uint32_t> neighbours;
    const std::uint32_t like = geometry_.like_of(vertex);
    if (like != kNoVertex)
        neighbours.push_back(like);
    else
        find_around(vertex, neighbours);
    if (std::ranges::all_of(neighbours, [&](std::uint32_t n) { return visibility.unoccluded(n); }))
        return false;
    std::vector<Seeing> around;
    around.reserve(neighbours.size());
    for (const std::uint32_t n : neighbours)
        around.push_back({.bits = visibility.at(n), .normal = normals_[n]});
    out.find(around, std::min(around.size(), kFewestNeighbours), directions, normals_[vertex], vertex);
    return true;
}

void Agreement::find(std::span<const Seeing> around, std::size_t fewest, const DirectionSet& directions,
                     const glm::vec3& normal, std::size_t number) {
    const std::size_t bundles = directions.bundles().size();
    const std::size_t checks = (kFewestChecks + bundles - 1) / bundles;  // in each bundle
    std::size_t sampled = 0;
    spared.resize(bundles);
    bits.assign((directions.size() + 63) / 64, 0);
    checked.assign(bits.size(), 0);
    traced.may_close.resize(bundles);
    for (std::size_t b = 0; b < bundles; ++b) {
        const RayBundle& bundle = directions.bundles()[b];
        unsigned open = 0, blocked = 0, one = 0, two = 0, three = 0;
        for (const Seeing& point : around) {
            const unsigned seen = bundle_bits(point.bits.data(), b);
            const unsigned above = dispatch<rays_above>(bundle, point.normal, 0.0F);
            open |= seen;
            blocked |= above & ~seen;
            three |= two & above;
            two |= one & above;
            one |= above;
        }
        const unsigned agreed = (fewest == 1   ? one
                                 : fewest == 2 ? two
                                               : three) &
                                ~(open & blocked) & dispatch<rays_above>(bundle, normal, kLowestRay);
        // The rays are at other places in neighbouring bundles and vertices.
        unsigned sample = 0;
        for (std::size_t i = 0; i < checks; ++i)
            sample |= 1U << ((7 * b + 5 * number + 3 * i) % RayBundle::kRays);
        sample &= agreed;
        spared[b] = static_cast<std::uint16_t>(agreed & ~sample);
        sampled += static_cast<std::size_t>(std::popcount(sample));
        traced.may_close[b] = static_cast<std::uint16_t>(~agreed | sample);
        add_bundle_bits(bits, b, open & agreed);
        add_bundle_bits(checked, b, sample);
    }
    traced.may_open = traced.may_close;
    few = sampled / kDiffering;
}

bool Agreement::find_wrong(std::span<const std::uint64_t> traced_bits, const RayCones& cones) {
    std::ranges::fill(traced.may_close, std::uint16_t{0});
    std::size_t count = 0;
    for (std::size_t w = 0; w < bits.size(); ++w)
        for (std::uint64_t differ = (traced_bits[w] ^ bits[w]) & checked[w]; differ != 0;
             differ &= differ - 1) {
            cones.add_beside(64 * w + static_cast<std::size_t>(std::countr_zero(differ)), traced.may_close);
            ++count;
        }
    if (count == 0) return false;
    if (count > few) traced.may_close = spared;
    few = spared.size() * RayBundle::kRays;  // of the rays beside the sample, any number may differ
    bool any = false;
    std::ranges::copy(traced_bits, bits.begin());
    std::ranges::fill(checked, std::uint64_t{0});
    for (std::size_t b = 0; b < spared.size(); ++b) {
        const auto beside = static_cast<std::uint16_t>(traced.may_close[b] & spared[b]);
        traced.may_close[b] = beside;
        spared[b] = static_cast<std::uint16_t>(spared[b] & ~beside);
        add_bundle_bits(checked, b, beside);
        any = any || beside != 0;
    }
    traced.may_open = traced.may_close;
    return any;
}

}  // namespace nicol
