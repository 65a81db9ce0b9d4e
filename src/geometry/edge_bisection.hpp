// SPDX-License-Identifier: MIT
// Refinement of triangles by splitting edges in the middle.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/key_table.hpp"

namespace nicol {

/// Wanted edge length at a point of a triangle.
struct WantedLength {
    std::uint32_t triangle;
    glm::vec3 weights;  ///< barycentric weights of the three corners
    float length;
};

/// Triangles that are bisected at edges without moving the surface. An edge is a pair of places. Vertices at
/// one place (at hard edges, or on both sides of a sheet) are split together, and so are all triangles at an
/// edge, however many. No vertex ever lies inside an edge.
///
/// Each triangle is bisected at its longest edge first (Rivara 1984), so angles stay above half of the
/// smallest given angle. Triangles without area are allowed.
class EdgeBisection {
public:
    /// Two places; the smaller one is in the high half.
    using Edge = std::uint64_t;
    /// Set of edges.
    class Edges {
    public:
        /// Adds an edge. Returns whether it is new.
        bool insert(Edge edge) { return edges_.try_emplace(edge, 1).second; }
        [[nodiscard]] bool contains(Edge edge) const { return edges_.find(edge) != nullptr; }
        [[nodiscard]] std::size_t size() const noexcept { return edges_.size(); }
        [[nodiscard]] bool empty() const noexcept { return edges_.size() == 0; }

    private:
        friend class EdgeBisection;
        KeyTable<std::uint8_t> edges_;
        std::vector<std::uint32_t> triangles_;  // triangles with an edge of the set, ascending; see close()
    };

    EdgeBisection(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles);

    [[nodiscard]] const std::vector<glm::vec3>& positions() const noexcept { return positions_; }
    [[nodiscard]] const std::vector<glm::uvec3>& triangles() const noexcept { return triangles_; }
    /// Returns, for each triangle, the given triangle that contains it; not decreasing.
    [[nodiscard]] const std::vector<std::uint32_t>& sources() const noexcept { return sources_; }
    /// Returns, for each added vertex, the two vertices that it lies halfway between; both have smaller
    /// numbers.
    [[nodiscard]] const std::vector<glm::uvec2>& parents() const noexcept { return parents_; }

    /// Returns the edge between two vertices.
    [[nodiscard]] Edge edge(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] Edge longest(const glm::uvec3& triangle) const;

    /// Adds the edges that have to be split first: the longest of each triangle with an edge of the set. The
    /// set is closed then, until another edge is added or triangles are split.
    void close(Edges& edges) const;
    /// Returns the number of vertices that splitting the edges of a closed set adds.
    [[nodiscard]] std::size_t cost(const Edges& edges) const;
    /// Splits the edges of a closed set. Moves `points`, which lie on these triangles, to the triangles'
    /// parts.
    void split(const Edges& edges, std::vector<WantedLength>& points);

private:
    // Squared length, then the edge as tie-breaker, so that all triangles at an edge agree which edge is
    // longer.
    struct Extent {
        double squared;
        Edge edge;
        // NOLINTNEXTLINE(modernize-use-nullptr): the zero is the comparison's own
        auto operator<=>(const Extent&) const = default;
    };
    [[nodiscard]] Extent extent(std::uint32_t a, std::uint32_t b) const;
    [[nodiscard]] bool any_edge(const glm::uvec3& triangle, const Edges& edges) const;
    [[nodiscard]] std::uint32_t middle(std::uint32_t a, std::uint32_t b);
    // Adds a triangle that is not cut, or a part of one that is.
    void keep(const glm::uvec3& triangle, std::uint32_t source, std::span<WantedLength> points);
    void cut(const glm::uvec3& triangle, std::uint32_t source, const Edges& edges,
             std::span<WantedLength> points);

    std::vector<glm::vec3> positions_;
    std::vector<std::uint32_t> places_;  // place of each vertex; equal positions have equal places
    std::uint32_t place_count_ = 0;
    std::vector<glm::uvec3> triangles_;
    std::vector<std::uint32_t> sources_;
    // Memory of the triangles before the last split(), for the next one.
    std::vector<glm::uvec3> former_triangles_;
    std::vector<std::uint32_t> former_sources_;
    std::vector<glm::uvec2> parents_;
    // State of split(): middle vertices by pair of vertices, and middle places by edge.
    KeyTable<std::uint32_t> middles_;
    KeyTable<std::uint32_t> middle_places_;
};

/// Position of a part of a triangle in the given triangle that contains the part.
struct TrianglePart {
    std::uint32_t source;
    std::array<glm::vec3, 3> corners;  ///< barycentric weights in the source triangle
};

/// Returns the positions of triangles in their source triangles. given: the source triangles, whose vertices
/// have numbers below `vertices`; parents, triangles, sources: results of EdgeBisection.
[[nodiscard]] std::vector<TrianglePart> triangle_parts(std::span<const glm::uvec3> given,
                                                       std::size_t vertices,
                                                       std::span<const glm::uvec2> parents,
                                                       std::span<const glm::uvec3> triangles,
                                                       std::span<const std::uint32_t> sources);

/// Returns a key of two numbers that does not depend on their order.
[[nodiscard]] inline std::uint64_t pair_key(std::uint32_t a, std::uint32_t b) {
    return a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a;
}

}  // namespace nicol
