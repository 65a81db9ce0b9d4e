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

/// Vertices at the ends of the edges that were added between two calls of update(). Most triangles have fewer
/// than two such corners, and then no edge of the set, which is found without a search.
class EdgeEnds {
public:
    /// places: the place of each vertex.
    EdgeEnds(std::span<const std::uint32_t> places, std::uint32_t place_count)
        : places_(places), at_places_(place_count, 0), at_vertices_(places.size(), 0) {}
    void add(EdgeBisection::Edge edge) { at_places_[edge >> 32] = at_places_[edge & 0xFFFFFFFFU] = 1; }
    /// Takes over the edges that were added since the last call, and forgets those before.
    void update() {
        for (std::size_t v = 0; v < places_.size(); ++v) at_vertices_[v] = at_places_[places_[v]];
        std::ranges::fill(at_places_, std::uint8_t{0});
    }
    /// Returns whether a triangle may have one of the edges of the last update().
    [[nodiscard]] bool on_triangle(const glm::uvec3& t) const {
        return at_vertices_[t.x] + at_vertices_[t.y] + at_vertices_[t.z] >= 2;
    }

private:
    std::span<const std::uint32_t> places_;
    std::vector<std::uint8_t> at_places_;
    std::vector<std::uint8_t> at_vertices_;
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
    struct Vertex {
        std::array<float, 3> coordinates;
        std::uint32_t number;
    };
    std::vector<Vertex> sorted;
    sorted.reserve(positions.size());
    for (const glm::vec3& p : positions)
        sorted.push_back({{p.x, p.y, p.z}, static_cast<std::uint32_t>(sorted.size())});
    std::ranges::sort(sorted, {}, &Vertex::coordinates);
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        if (i > 0 && sorted[i].coordinates != sorted[i - 1].coordinates) ++place_count_;
        places_[sorted[i].number] = place_count_;
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

bool EdgeBisection::any_edge(const glm::uvec3& t, const Edges& edges) const {
    return edges.contains(edge(t.x, t.y)) || edges.contains(edge(t.y, t.z)) || edges.contains(edge(t.z, t.x));
}

void EdgeBisection::close(Edges& edges) const {
    EdgeEnds ends(places_, place_count_);
    edges.edges_.for_each([&ends](Edge edge, std::uint8_t) { ends.add(edge); });
    std::vector<std::uint8_t> found(triangles_.size(), 0);
    // Each turn finds the triangles at the edges that the turn before has added.
    for (bool more = true; more;) {
        more = false;
        ends.update();
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            const glm::uvec3& t = triangles_[i];
            if (!ends.on_triangle(t) || found[i] != 0 || !any_edge(t, edges)) continue;
            found[i] = 1;
            const Edge first = longest(t);
            if (!edges.insert(first)) continue;
            ends.add(first);
            more = true;
        }
    }
    edges.triangles_.clear();
    for (std::uint32_t i = 0; i < found.size(); ++i)
        if (found[i] != 0) edges.triangles_.push_back(i);
}

std::size_t EdgeBisection::cost(const Edges& edges) const {
    KeyTable<std::uint8_t> pairs;
    for (const std::uint32_t i : edges.triangles_) {
        const glm::uvec3& t = triangles_[i];
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
    std::swap(triangles_, former_triangles_);
    std::swap(sources_, former_sources_);
    triangles_.clear();
    sources_.clear();
    triangles_.reserve(former_triangles_.size() + 2 * edges.size());
    sources_.reserve(triangles_.capacity());
    if (!std::ranges::is_sorted(points, {}, &WantedLength::triangle))
        std::ranges::stable_sort(points, {}, &WantedLength::triangle);
    auto point = points.begin();
    std::size_t done = 0;
    // Triangles before `end` without an edge of the set are kept.
    const auto keep_before = [&](std::size_t end) {
        const auto shift = static_cast<std::uint32_t>(triangles_.size() - done);
        for (; point != points.end() && point->triangle < end; ++point) point->triangle += shift;
        const auto copy = [&](const auto& from, auto& to) {
            to.insert(to.end(), from.begin() + static_cast<std::ptrdiff_t>(done),
                      from.begin() + static_cast<std::ptrdiff_t>(end));
        };
        copy(former_triangles_, triangles_);
        copy(former_sources_, sources_);
    };
    for (const std::uint32_t i : edges.triangles_) {
        keep_before(i);
        const auto last =
            std::find_if(point, points.end(), [i](const WantedLength& p) { return p.triangle != i; });
        cut(former_triangles_[i], former_sources_[i], edges, {point, last});
        point = last;
        done = i + 1;
    }
    keep_before(former_triangles_.size());
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
