// SPDX-License-Identifier: MIT
#include "surfaces/lane_triangles.hpp"

#include <glm/geometric.hpp>
#include <numeric>
#include <vector>

#include "surfaces/tangents.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

/// Returns triangles of several sizes and shapes, with texture coordinates.
WorldGeometry some_triangles() {
    WorldGeometry out;
    const float sizes[] = {1, 1e-12F, 1e12F, 0.3F};
    for (std::uint32_t k = 0; k < kLanes - 3; ++k) {
        const float size = sizes[k % 4], angle = 0.7F * static_cast<float>(k),
                    narrow = k % 3 == 0 ? 1e-5F : 1;
        const glm::vec3 x(std::cos(angle), std::sin(angle), 0.2F * angle), y(-x.y, x.x, narrow);
        out.positions.insert(out.positions.end(), {size * glm::vec3(1, 2, 3), size * (x + glm::vec3(1, 2, 3)),
                                                   size * (narrow * y + 0.5F * x + glm::vec3(1, 2, 3))});
        for (int corner = 0; corner < 3; ++corner)
            out.normals.push_back(glm::normalize(glm::vec3(0.1F * static_cast<float>(corner), angle, 1)));
        out.triangles.emplace_back(3 * k, 3 * k + 1, 3 * k + 2);
        const float u = std::cos(2 * angle), v = std::sin(2 * angle);
        // The texture of every fifth triangle has no area.
        out.texcoords.push_back({glm::vec2(0.1F, 0.2F), {0.1F + u, 0.2F + v}, {0.1F - v, 0.2F + u}});
        if (k % 5 == 4) out.texcoords.back()[2] = out.texcoords.back()[1];
    }
    return out;
}

}  // namespace

TEST_CASE("facets and tangents of triangles side by side are those of single triangles") {
    const WorldGeometry geometry = some_triangles();
    std::vector<std::uint32_t> indices(geometry.triangles.size());
    std::iota(indices.begin(), indices.end(), 0U);
    const LaneTriangles triangles = LaneTriangles::of(geometry, indices);
    LaneVectors normals;
    const glm::vec3 weights(0.2F, 0.3F, 0.5F);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const std::size_t own = i < indices.size() ? 3 * i : 0;
        put(normals, i,
            glm::normalize(weights.x * geometry.normals[own] + weights.y * geometry.normals[own + 1] +
                           weights.z * geometry.normals[own + 2]));
    }
    const LaneVectors facets = triangles.facets(normals);
    const LaneVectors tangents = texture_tangents(geometry, indices, triangles, normals);
    for (std::size_t i = 0; i < kLanes; ++i) {
        CAPTURES(i);
        const std::uint32_t own = i < indices.size() ? indices[i] : 0;
        const glm::dvec3 first(geometry.positions[3 * own]);
        const glm::dvec3 facet =
            glm::normalize(glm::cross(glm::dvec3(geometry.positions[3 * own + 1]) - first,
                                      glm::dvec3(geometry.positions[3 * own + 2]) - first));
        CHECK(glm::distance(glm::dvec3(vector_at(facets, i)), facet) < 1e-6);
        CHECK(glm::distance(vector_at(tangents, i), tangent(geometry, own, weights)) < 1e-4F);
        CHECK(glm::length(vector_at(tangents, i)) == doctest::Approx(own % 5 == 4 ? 0 : 1));
    }
}

TEST_CASE("a triangle without an area has the other normal") {
    LaneTriangles triangles{};
    LaneVectors normals;
    for (std::size_t i = 0; i < kLanes; ++i) put(normals, i, {0, 0.6F, 0.8F});
    CHECK(glm::distance(vector_at(triangles.facets(normals), 5), {0, 0.6F, 0.8F}) < 1e-6F);
}
