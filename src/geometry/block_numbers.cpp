// SPDX-License-Identifier: MIT
#include "geometry/block_numbers.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/common.hpp>

#include "simd/lanes.hpp"

namespace nicol {
namespace {

// Length of a difference of unit normals that separates vertices as much as the size of the mesh does.
constexpr float kNormalOfSize = 0.3F;

struct Vertex {
    std::array<float, 6> place;  // position in sizes of the mesh, and the weighted normal
    std::uint32_t index;
};

// Returns the coordinate in which places differ most.
std::size_t widest(std::span<const Vertex> vertices) {
    std::array<float, 6> lower = vertices.front().place, upper = lower;
    for (const Vertex& vertex : vertices)
        for (std::size_t k = 0; k < lower.size(); ++k) {
            lower[k] = std::min(lower[k], vertex.place[k]);
            upper[k] = std::max(upper[k], vertex.place[k]);
        }
    std::size_t out = 0;
    for (std::size_t k = 1; k < lower.size(); ++k)
        if (upper[k] - lower[k] > upper[out] - lower[out]) out = k;
    return out;
}

// Sorts vertices by halving them at the median of their widest coordinate, to single blocks.
void sort(std::span<Vertex> vertices) {
    if (vertices.size() <= kLanes) {
        std::ranges::sort(vertices, {}, &Vertex::index);
        return;
    }
    const std::size_t k = widest(vertices);
    const std::size_t half = (vertices.size() / 2 + kLanes - 1) / kLanes * kLanes;
    // Equal coordinates are told apart, so that the halves do not depend on the algorithm.
    std::ranges::nth_element(vertices, vertices.begin() + static_cast<std::ptrdiff_t>(half),
                             [k](const Vertex& a, const Vertex& b) {
                                 return a.place[k] != b.place[k] ? a.place[k] < b.place[k]
                                                                 : a.index < b.index;
                             });
    sort(vertices.first(half));
    sort(vertices.subspan(half));
}

}  // namespace

std::vector<std::uint32_t> block_numbers(std::span<const glm::vec3> positions,
                                         std::span<const glm::vec3> normals) {
    std::vector<std::uint32_t> out;
    if (positions.size() < kLeastOrdered) return out;
    glm::vec3 lower = positions.front(), upper = lower;
    for (const glm::vec3& position : positions) {
        lower = glm::min(lower, position);
        upper = glm::max(upper, position);
    }
    // Single precision has neither the size of the largest meshes nor the inverse of that of the smallest.
    const glm::dvec3 origin(lower), sides = glm::dvec3(upper) - origin;
    const double size = std::max({sides.x, sides.y, sides.z});
    const double scale = size > 0 ? 1 / size : 0;
    std::vector<Vertex> vertices;
    vertices.reserve(positions.size());
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const glm::vec3 p((glm::dvec3(positions[v]) - origin) * scale), n = kNormalOfSize * normals[v];
        vertices.push_back({{p.x, p.y, p.z, n.x, n.y, n.z}, static_cast<std::uint32_t>(v)});
    }
    sort(vertices);
    out.resize(vertices.size());
    for (std::size_t number = 0; number < vertices.size(); ++number)
        out[vertices[number].index] = static_cast<std::uint32_t>(number);
    return out;
}

}  // namespace nicol
