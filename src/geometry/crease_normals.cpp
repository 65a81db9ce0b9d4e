// SPDX-License-Identifier: MIT
#include "geometry/crease_normals.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <tuple>
#include <vector>

namespace nicol::geometry {
namespace {

constexpr std::size_t kNoCorner = ~std::size_t{0};

// Corner c belongs to triangle c / 3. The edge of a corner leads from it to the next corner of its triangle.
std::size_t next_corner(std::size_t c) {
    return c % 3 == 2 ? c - 2 : c + 1;
}
std::size_t previous_corner(std::size_t c) {
    return c % 3 == 0 ? c + 2 : c - 1;
}

class CreaseNormals {
public:
    CreaseNormals(PolygonMesh& triangles, double degrees, const LoadBudget& budget)
        : triangles_(triangles),
          least_cosine_(std::cos(degrees * std::numbers::pi / 180.0)),
          budget_(budget) {}

    void run() {
        join_edges();
        for (std::size_t f = 0; f < triangles_.corners.size() / 3; ++f) add_face_normal(f);
        for (std::size_t c = 0; c < triangles_.corners.size(); ++c)
            if (triangles_.corners[c].normal == PolygonMesh::kNone) smooth(c);
    }

private:
    struct Edge {
        std::uint32_t from, to;
        std::size_t corner;
    };

    /// Finds the triangle on the other side of each edge: the first that has the edge in the opposite
    /// direction, for the first that has it in this one. Further triangles at an edge end there.
    void join_edges() {
        std::vector<Edge> edges;
        edges.reserve(triangles_.corners.size());
        for (std::size_t c = 0; c < triangles_.corners.size(); ++c)
            edges.push_back({position(c), position(next_corner(c)), c});
        std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) {
            budget_.step(4);
            return std::tie(a.from, a.to, a.corner) < std::tie(b.from, b.to, b.corner);
        });
        const auto same = [](const Edge& a, const Edge& b) { return a.from == b.from && a.to == b.to; };
        edges.erase(std::unique(edges.begin(), edges.end(), same), edges.end());
        opposite_.assign(triangles_.corners.size(), kNoCorner);
        for (const Edge& edge : edges) {
            budget_.step(16);
            const Edge wanted{edge.to, edge.from, 0};
            const auto found = std::lower_bound(
                edges.begin(), edges.end(), wanted,
                [](const Edge& a, const Edge& b) { return std::tie(a.from, a.to) < std::tie(b.from, b.to); });
            if (found != edges.end() && same(*found, wanted)) opposite_[edge.corner] = found->corner;
        }
    }

    void add_face_normal(std::size_t f) {
        const glm::dvec3 first = point(3 * f);
        const glm::dvec3 area = glm::cross(point(3 * f + 1) - first, point(3 * f + 2) - first);
        const double length = glm::length(area);
        normals_.push_back(length > 0 ? area / length : glm::dvec3(0));
    }

    [[nodiscard]] std::uint32_t position(std::size_t c) const { return triangles_.corners[c].position; }
    [[nodiscard]] glm::dvec3 point(std::size_t c) const {
        return glm::dvec3(triangles_.positions[position(c)]);
    }

    // The corner at the same position in the triangle beside, clockwise and counter-clockwise, up to edges
    // that are hard or that the surface ends at.
    [[nodiscard]] std::size_t clockwise(std::size_t c) const {
        const std::size_t other = opposite_[c];
        return other == kNoCorner ? kNoCorner : if_smooth(c, next_corner(other));
    }
    [[nodiscard]] std::size_t counter_clockwise(std::size_t c) const {
        const std::size_t other = opposite_[previous_corner(c)];
        return other == kNoCorner ? kNoCorner : if_smooth(c, other);
    }
    [[nodiscard]] std::size_t if_smooth(std::size_t c, std::size_t beside) const {
        return glm::dot(normals_[c / 3], normals_[beside / 3]) >= least_cosine_ ? beside : kNoCorner;
    }

    [[nodiscard]] double angle_at(std::size_t c) const {
        const glm::dvec3 u = point(next_corner(c)) - point(c);
        const glm::dvec3 v = point(previous_corner(c)) - point(c);
        return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
    }

    // One normal for the corners about a position from hard edge to hard edge.
    void smooth(std::size_t corner) {
        std::size_t first = corner;
        for (std::size_t before = clockwise(first); before != kNoCorner && before != corner;
             before = clockwise(first))
            first = before;
        const auto normal = static_cast<std::uint32_t>(triangles_.normals.size());
        glm::dvec3 sum(0);
        for (std::size_t c = first; c != kNoCorner; c = counter_clockwise(c)) {
            if (triangles_.corners[c].normal != PolygonMesh::kNone) break;  // once around
            sum += normals_[c / 3] * angle_at(c);
            triangles_.corners[c].normal = normal;
            budget_.step(16);
        }
        const double length = glm::length(sum);
        triangles_.normals.emplace_back(length > 0 ? sum / length : glm::dvec3(0));
    }

    PolygonMesh& triangles_;
    double least_cosine_;
    const LoadBudget& budget_;
    std::vector<std::size_t> opposite_;  // by corner, the one whose edge is the same in the other direction
    std::vector<glm::dvec3> normals_;    // of the faces
};

}  // namespace

void add_crease_normals(PolygonMesh& triangles, double degrees, const LoadBudget& budget) {
    CreaseNormals(triangles, degrees, budget).run();
}

}  // namespace nicol::geometry
