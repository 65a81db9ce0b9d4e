// SPDX-License-Identifier: MIT
#include "surfaces/convex_bodies.hpp"

#include <algorithm>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <tuple>
#include <utility>

#include "geometry/welded_positions.hpp"
#include "simd/lane_transpose.hpp"
#include "surfaces/open_triangles.hpp"

namespace nicol {
namespace {

struct BodyBox {
    glm::vec3 lower{std::numeric_limits<float>::max()};
    glm::vec3 upper{std::numeric_limits<float>::lowest()};

    void add(const glm::vec3& point) {
        lower = glm::min(lower, point);
        upper = glm::max(upper, point);
    }
    [[nodiscard]] bool meets(const BodyBox& other) const {
        return glm::all(glm::lessThanEqual(lower, other.upper)) &&
               glm::all(glm::lessThanEqual(other.lower, upper));
    }
};

BodyBox body_box(std::span<const glm::vec3> positions) {
    BodyBox out;
    for (const glm::vec3& position : positions) out.add(position);
    return out;
}

std::span<const glm::vec3> body_positions(const WorldGeometry& geometry, const VertexRange& range) {
    return std::span(geometry.positions).subspan(range.first, range.last - range.first);
}

std::span<const glm::uvec3> of_batch(const WorldGeometry& geometry, const TriangleBatch& batch) {
    return std::span(geometry.triangles).subspan(batch.first, batch.last - batch.first);
}

// No ray meets a triangle without an area.
bool has_area(const WorldGeometry& geometry, const glm::uvec3& of) {
    const glm::dvec3 first(geometry.positions[of.x]);
    const glm::dvec3 second(geometry.positions[of.y]), third(geometry.positions[of.z]);
    return glm::length(glm::cross(second - first, third - first)) > 0;
}

// Returns whether triangles of a range have no vertex of the range above them.
bool is_convex(const WorldGeometry& geometry, std::span<const TriangleBatch> batches, std::size_t body) {
    const VertexRange& range = geometry.ranges[body];
    const OpenTriangles triangles(body_positions(geometry, range));
    const glm::uvec3 first(static_cast<std::uint32_t>(range.first));
    return std::ranges::all_of(batches, [&](const TriangleBatch& batch) {
        return batch.range != body ||
               std::ranges::all_of(of_batch(geometry, batch), [&](const glm::uvec3& of) {
                   return !has_area(geometry, of) || triangles.open(of - first);
               });
    });
}

// Returns whether no triangle of another range touches the box of one. boxes: of all ranges.
bool is_empty(const WorldGeometry& geometry, std::span<const TriangleBatch> batches,
              std::span<const BodyBox> boxes, std::size_t body) {
    const auto touches = [&](const glm::uvec3& of) {
        BodyBox box;
        for (glm::length_t k = 0; k < 3; ++k) box.add(geometry.positions[of[k]]);
        return box.meets(boxes[body]);
    };
    return std::ranges::none_of(batches, [&](const TriangleBatch& batch) {
        return batch.range != body && boxes[batch.range].meets(boxes[body]) &&
               std::ranges::any_of(of_batch(geometry, batch), touches);
    });
}

// Calls connect(side, triangle) for each side of a body's triangles, 3 triangle + corner, and the triangle
// beyond it. Edges of other than two triangles, as they are at holes, connect none.
template <class Connect>
void for_neighbours(const WorldGeometry& geometry, std::span<const TriangleBatch> batches, std::size_t body,
                    const Connect& connect) {
    const VertexRange& range = geometry.ranges[body];
    const std::vector<std::uint32_t> places = welded_positions(body_positions(geometry, range));
    struct Edge {
        std::uint32_t first, last;  // places, in ascending order
        std::uint32_t side;         // 3 triangle + corner
        [[nodiscard]] auto ends() const { return std::pair(first, last); }
    };
    std::vector<Edge> edges;
    for (const TriangleBatch& batch : batches) {
        if (batch.range != body) continue;
        edges.reserve(edges.size() + 3 * (batch.last - batch.first));
        for (std::size_t t = batch.first; t < batch.last; ++t) {
            if (!has_area(geometry, geometry.triangles[t])) continue;
            for (std::uint32_t k = 0; k < 3; ++k) {
                const auto place = [&](std::uint32_t corner) {
                    return places[geometry.triangles[t][static_cast<glm::length_t>(corner % 3)] -
                                  range.first];
                };
                const auto [first, last] = std::minmax({place(k + 1), place(k + 2)});
                edges.push_back({first, last, static_cast<std::uint32_t>(3 * t) + k});
            }
        }
    }
    std::ranges::sort(edges, {}, &Edge::ends);
    for (std::size_t begin = 0; begin < edges.size();) {
        std::size_t end = begin + 1;
        while (end < edges.size() && edges[end].ends() == edges[begin].ends()) ++end;
        if (end - begin == 2) {
            const std::uint32_t a = edges[begin].side, b = edges[begin + 1].side;
            connect(a, b / 3);
            connect(b, a / 3);
        }
        begin = end;
    }
}

// Returns the positions and then the normals of a triangle's corners.
std::array<float, 18> row_of(const WorldGeometry& geometry, std::size_t triangle) {
    std::array<float, 18> out;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t corner = geometry.triangles[triangle][static_cast<glm::length_t>(k)];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            out[3 * k + axis] = geometry.positions[corner][static_cast<glm::length_t>(axis)];
            out[9 + 3 * k + axis] = geometry.normals[corner][static_cast<glm::length_t>(axis)];
        }
    }
    return out;
}

// Most triangles of a walk. Longer walks cost more than tracing the ray.
constexpr int kMostSteps = 6;

}  // namespace

ConvexBodies::ConvexBodies(const WorldGeometry& geometry, std::span<const std::uint8_t> chosen) {
    if (std::ranges::none_of(chosen, [](std::uint8_t is) { return is != 0; })) return;
    const std::vector<TriangleBatch> batches = triangle_batches(geometry);
    std::vector<BodyBox> boxes;
    boxes.reserve(geometry.ranges.size());
    for (const VertexRange& range : geometry.ranges)
        boxes.push_back(body_box(body_positions(geometry, range)));
    for (std::size_t range = 0; range < chosen.size(); ++range) {
        if (chosen[range] == 0 || !is_convex(geometry, batches, range) ||
            !is_empty(geometry, batches, boxes, range))
            continue;
        bodies_.resize(chosen.size());
        bodies_[range] = body_of(geometry, batches, range);
    }
}

ConvexBodies::Body ConvexBodies::body_of(const WorldGeometry& geometry,
                                         std::span<const TriangleBatch> batches, std::size_t range) {
    Body out;
    for (const TriangleBatch& batch : batches) {
        if (batch.range != range) continue;
        if (out.triangles.empty()) out.first = static_cast<std::uint32_t>(batch.first);
        out.triangles.resize(batch.last - out.first);
        for (std::size_t t = batch.first; t < batch.last; ++t) {
            Triangle& triangle = out.triangles[t - out.first];
            triangle.row = row_of(geometry, t);
            triangle.neighbours.fill(static_cast<std::uint32_t>(t));
        }
    }
    for_neighbours(geometry, batches, range, [&](std::uint32_t side, std::uint32_t triangle) {
        out.triangles[side / 3 - out.first].neighbours[side % 3] = triangle;
    });
    return out;
}

std::uint64_t ConvexBodies::bytes() const noexcept {
    std::uint64_t out = bodies_.size() * sizeof(Body);
    for (const Body& body : bodies_) out += body.triangles.size() * sizeof(Triangle);
    return out;
}

std::uint32_t ConvexBodies::leave(std::size_t range, const LaneVectors& origins,
                                  const LaneVectors& directions, std::uint32_t some,
                                  std::array<std::uint32_t, kLanes>& triangles, LaneTriangles& at,
                                  LaneMeetings& out) const {
    static_assert(sizeof(LaneTriangles) == std::tuple_size_v<decltype(Triangle::row)> * sizeof(Lanes));
    static_assert(offsetof(LaneTriangles, normals) == 9 * sizeof(Lanes));
    // Registers exchange as many numbers as lanes: the positions, and most of the normals.
    constexpr std::size_t rest = std::tuple_size_v<decltype(Triangle::row)> - kLanes;
    const Body& body = bodies_[range];
    std::array<const float*, kLanes> rows;
    Lanes* const lanes = &at.corners.front().x;
    std::uint32_t met = 0;
    for (int step = 1;; ++step) {
        for (std::size_t i = 0; i < kLanes; ++i)
            rows[i] = body.triangles[triangles[i] - body.first].row.data();
        to_lanes(rows, kLanes, lanes);
        meet_planes(origins, directions, at, out);
        met = 0;
        bool walks = false;
        for (std::size_t i = 0; i < kLanes; ++i) {
            if ((some >> i & 1) == 0) continue;
            if (out.beyond[i] < 0) {
                met |= 1U << i;
                continue;
            }
            if (step == kMostSteps) continue;
            const Triangle& from = body.triangles[triangles[i] - body.first];
            const std::uint32_t next = from.neighbours[static_cast<std::size_t>(out.beyond[i])];
            walks = walks || next != triangles[i];
            triangles[i] = next;
        }
        if (!walks) break;
    }
    for (const float*& row : rows) row += kLanes;
    to_lanes(rows, rest, lanes + kLanes);
    return met;
}

}  // namespace nicol
