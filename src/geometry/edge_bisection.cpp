// SPDX-License-Identifier: MIT
#include "geometry/edge_bisection.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>
#include <utility>

namespace nicol {
namespace {

/// Ends of the edges of a set, by place. Most triangles have no edge of the set, and most of these have fewer
/// than two such places, which is found without a search.
class EdgeEnds {
public:
    EdgeEnds(const EdgeBisection::Edges& edges, std::uint32_t places) : ends_(places, 0) {
        for (const EdgeBisection::Edge edge : edges) add(edge);
    }
    void add(EdgeBisection::Edge edge) { ends_[edge >> 32] = ends_[edge & 0xFFFFFFFFU] = 1; }
    /// Returns whether a triangle of these places may have an edge of the set.
    [[nodiscard]] bool on_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        return ends_[a] + ends_[b] + ends_[c] >= 2;
    }

private:
    std::vector<std::uint8_t> ends_;
};

/// Weights of a triangle's corners at the vertices of its parts. Each vertex is computed once a triangle.
class CornerWeights {
public:
    /// given: number of vertices before the first that was added between two parents.
    CornerWeights(std::size_t given, std::span<const glm::uvec2> parents)
        : given_(given), parents_(parents), known_(parents.size()) {}

    [[nodiscard]] glm::vec3 at(std::uint32_t vertex, std::uint32_t triangle, const glm::uvec3& corners) {
        if (vertex < given_)
            return {corners.x == vertex ? 1 : 0, corners.y == vertex ? 1 : 0, corners.z == vertex ? 1 : 0};
        Known& known = known_[vertex - given_];
        if (known.triangle != triangle) {
            // Parents have smaller indices.
            const glm::uvec2& pair = parents_[vertex - given_];
            known.weights = 0.5F * at(pair.x, triangle, corners) + 0.5F * at(pair.y, triangle, corners);
            known.triangle = triangle;
        }
        return known.weights;
    }

private:
    struct Known {
        std::uint32_t triangle = ~std::uint32_t{0};
        glm::vec3 weights;
    };
    std::size_t given_;
    std::span<const glm::uvec2> parents_;
    std::vector<Known> known_;
};

}  // namespace

EdgeBisection::EdgeBisection(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles)
    : positions_(positions.begin(), positions.end()),
      places_(positions.size()),
      triangles_(triangles.begin(), triangles.end()),
      sources_(triangles.size()) {
    std::iota(sources_.begin(), sources_.end(), 0U);
    std::vector<std::uint32_t> sorted(positions.size());
    std::iota(sorted.begin(), sorted.end(), 0U);
    const auto coordinates = [&](std::uint32_t v) {
        return std::array{positions_[v].x, positions_[v].y, positions_[v].z};
    };
    std::ranges::sort(sorted, {}, coordinates);
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        if (i > 0 && coordinates(sorted[i]) != coordinates(sorted[i - 1])) ++place_count_;
        places_[sorted[i]] = place_count_;
    }
    ++place_count_;
}

EdgeBisection::Edge EdgeBisection::edge(std::uint32_t a, std::uint32_t b) const {
    return pair_key(places_[a], places_[b]);
}

EdgeBisection::Extent EdgeBisection::extent(std::uint32_t a, std::uint32_t b) const {
    const glm::dvec3 along = glm::dvec3(positions_[a]) - glm::dvec3(positions_[b]);
    return {.squared = glm::dot(along, along), .edge = edge(a, b)};
}

EdgeBisection::Edge EdgeBisection::longest(const glm::uvec3& t) const {
    return std::max({extent(t.x, t.y), extent(t.y, t.z), extent(t.z, t.x)}).edge;
}

void EdgeBisection::close(Edges& edges) const {
    EdgeEnds ends(edges, place_count_);
    for (bool more = true; more;) {
        more = false;
        for (const glm::uvec3& t : triangles_) {
            if (!ends.on_triangle(places_[t.x], places_[t.y], places_[t.z])) continue;
            if (!edges.contains(edge(t.x, t.y)) && !edges.contains(edge(t.y, t.z)) &&
                !edges.contains(edge(t.z, t.x))) {
                continue;
            }
            const Edge first = longest(t);
            if (!edges.insert(first).second) continue;
            ends.add(first);
            more = true;
        }
    }
}

std::size_t EdgeBisection::cost(const Edges& edges) const {
    const EdgeEnds ends(edges, place_count_);
    KeyTable<std::uint8_t> pairs;
    for (const glm::uvec3& t : triangles_) {
        if (!ends.on_triangle(places_[t.x], places_[t.y], places_[t.z])) continue;
        for (glm::length_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k];
            const std::uint32_t b = t[(k + 1) % 3];
            if (edges.contains(edge(a, b))) pairs.try_emplace(pair_key(a, b), 1);
        }
    }
    return pairs.size();
}

std::uint32_t EdgeBisection::middle(std::uint32_t a, std::uint32_t b) {
    const auto vertex = static_cast<std::uint32_t>(positions_.size());
    const auto [found, is_new] = middles_.try_emplace(pair_key(a, b), vertex);
    if (is_new) {
        const auto place = middle_places_.try_emplace(edge(a, b), place_count_);
        if (place.second) ++place_count_;
        places_.push_back(*place.first);
        // Each term is halved before the sum, which could be out of range.
        positions_.push_back(0.5F * positions_[a] + 0.5F * positions_[b]);
        parents_.emplace_back(a, b);
    }
    return *found;
}

void EdgeBisection::keep(const glm::uvec3& t, std::uint32_t source, std::span<WantedLength> points) {
    for (WantedLength& point : points) point.triangle = static_cast<std::uint32_t>(triangles_.size());
    triangles_.push_back(t);
    sources_.push_back(source);
}

void EdgeBisection::cut(const glm::uvec3& t, std::uint32_t source, const Edges& edges,
                        std::span<WantedLength> points) {
    std::optional<Extent> longest;
    glm::length_t at = 0;
    for (glm::length_t k = 0; k < 3; ++k) {
        const Extent side = extent(t[k], t[(k + 1) % 3]);
        if (!edges.contains(side.edge) || (longest && side < *longest)) continue;
        longest = side;
        at = k;
    }
    if (!longest) return keep(t, source, points);
    const glm::length_t next = (at + 1) % 3;
    const std::uint32_t vertex = middle(t[at], t[next]);
    const auto far = std::partition(points.begin(), points.end(), [&](const WantedLength& point) {
        return point.weights[at] > point.weights[next];
    });
    const auto half = [&](glm::length_t replaced, std::span<WantedLength> inside) {
        // In the half that lost this corner the middle has twice its weight.
        const glm::length_t kept = replaced == at ? next : at;
        for (WantedLength& point : inside) {
            point.weights[kept] -= point.weights[replaced];
            point.weights[replaced] *= 2;
        }
        glm::uvec3 part = t;
        part[replaced] = vertex;
        cut(part, source, edges, inside);
    };
    half(next, {points.begin(), far});
    half(at, {far, points.end()});
}

void EdgeBisection::split(const Edges& edges, std::vector<WantedLength>& points) {
    const std::vector<glm::uvec3> triangles = std::exchange(triangles_, {});
    const std::vector<std::uint32_t> sources = std::exchange(sources_, {});
    triangles_.reserve(triangles.size() + 2 * edges.size());
    sources_.reserve(triangles_.capacity());
    const EdgeEnds ends(edges, place_count_);
    if (!std::ranges::is_sorted(points, {}, &WantedLength::triangle))
        std::ranges::stable_sort(points, {}, &WantedLength::triangle);
    auto first = points.begin();
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const auto last =
            std::find_if(first, points.end(), [i](const WantedLength& p) { return p.triangle != i; });
        const glm::uvec3& t = triangles[i];
        if (ends.on_triangle(places_[t.x], places_[t.y], places_[t.z]))
            cut(t, sources[i], edges, {first, last});
        else
            keep(t, sources[i], {first, last});
        first = last;
    }
    middles_ = {};
    middle_places_ = {};
}

std::vector<TrianglePart> triangle_parts(std::span<const glm::uvec3> given, std::size_t vertices,
                                         std::span<const glm::uvec2> parents,
                                         std::span<const glm::uvec3> triangles,
                                         std::span<const std::uint32_t> sources) {
    std::vector<TrianglePart> parts;
    parts.reserve(triangles.size());
    CornerWeights weights(vertices, parents);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const std::uint32_t source = sources[i];
        const glm::uvec3& t = triangles[i];
        const glm::uvec3& of = given[source];
        if (t == of) {
            parts.push_back({.source = source, .corners = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}});
            continue;
        }
        const auto at = [&](std::uint32_t vertex) { return weights.at(vertex, source, of); };
        parts.push_back({.source = source, .corners = {at(t.x), at(t.y), at(t.z)}});
    }
    return parts;
}

}  // namespace nicol
