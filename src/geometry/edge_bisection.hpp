// SPDX-License-Identifier: MIT
// Triangles made smaller by splitting edges in the middle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace nicol {

/// A point on a triangle, and how long edges there may be.
struct WantedLength {
    std::uint32_t triangle;
    glm::vec3 weights;  ///< barycentric, of the three corners
    float length;
};

/// Triangles that are bisected at edges without moving the surface. An edge is a pair of places: vertices in
/// the same place, as at hard edges and on both sides of a sheet, are split together, and so are all
/// triangles at an edge, however many. No vertex ever lies on an edge that goes on past it.
///
/// A triangle is bisected at its longest edge first (Rivara 1984), so angles stay above half of the smallest
/// that was given. Works on any triangles, those without area too.
class EdgeBisection {
public:
    /// Of two places, the smaller in the high half.
    using Edge = std::uint64_t;
    using Edges = std::unordered_set<Edge>;

    EdgeBisection(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles);

    [[nodiscard]] const std::vector<glm::vec3>& positions() const noexcept { return positions_; }
    [[nodiscard]] const std::vector<glm::uvec3>& triangles() const noexcept { return triangles_; }
    /// The given triangle that each is a part of; not decreasing.
    [[nodiscard]] const std::vector<std::uint32_t>& sources() const noexcept { return sources_; }
    /// The vertices that each added one is in the middle of; they come before it.
    [[nodiscard]] const std::vector<glm::uvec2>& parents() const noexcept { return parents_; }

    /// Between two vertices.
    [[nodiscard]] Edge edge(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] Edge longest(const glm::uvec3& triangle) const;

    /// Adds the edges that have to be split first: the longest of each triangle with an edge of the set.
    void close(Edges& edges) const;
    /// How many vertices it takes to split these edges.
    [[nodiscard]] std::size_t cost(const Edges& edges) const;
    /// Splits the edges of a closed set. `points` lie on these triangles, and are moved to their parts.
    void split(const Edges& edges, std::vector<WantedLength>& points);

private:
    // Squared length, then the edge itself, so that all triangles at an edge agree which is longer.
    struct Extent {
        double squared;
        Edge edge;
        // NOLINTNEXTLINE(modernize-use-nullptr): the zero is the comparison's own
        auto operator<=>(const Extent&) const = default;
    };
    [[nodiscard]] Extent extent(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] std::uint32_t middle(std::uint32_t a, std::uint32_t b);
    void cut(const glm::uvec3& triangle, std::uint32_t source, const Edges& edges,
             std::span<WantedLength> points);

    std::vector<glm::vec3> positions_;
    std::vector<std::uint32_t> places_;  // of vertices: the same number where positions are equal
    std::uint32_t place_count_ = 0;
    std::vector<glm::uvec3> triangles_;
    std::vector<std::uint32_t> sources_;
    std::vector<glm::uvec2> parents_;
    // During split(): the vertices and places in the middle of pairs of vertices and of edges.
    std::unordered_map<std::uint64_t, std::uint32_t> middles_;
    std::unordered_map<Edge, std::uint32_t> middle_places_;
};

/// A key of two numbers in either order.
[[nodiscard]] inline std::uint64_t pair_key(std::uint32_t a, std::uint32_t b) {
    return a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a;
}

}  // namespace nicol
