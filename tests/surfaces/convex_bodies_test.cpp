// SPDX-License-Identifier: MIT
#include "surfaces/convex_bodies.hpp"

#include <array>
#include <bit>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/ray_scene.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

/// Adds a mesh as a range of its own.
void add(WorldGeometry& geometry, const Mesh& mesh) {
    const auto first = static_cast<std::uint32_t>(geometry.positions.size());
    geometry.positions.insert(geometry.positions.end(), mesh.positions.begin(), mesh.positions.end());
    geometry.normals.insert(geometry.normals.end(), mesh.normals.begin(), mesh.normals.end());
    for (const glm::uvec3& triangle : mesh.triangles) geometry.triangles.push_back(triangle + first);
    geometry.one_sided = geometry.triangles.size();
    geometry.ranges.push_back({.first = first,
                               .last = geometry.positions.size(),
                               .material = nullptr,
                               .instance = static_cast<std::uint32_t>(geometry.ranges.size())});
}

Mesh floor_at(float height) {
    Mesh out;
    out.positions = {{-5, height, -5}, {5, height, -5}, {5, height, 5}, {-5, height, 5}};
    out.normals.assign(4, {0, 1, 0});
    out.triangles = {{0, 2, 1}, {0, 3, 2}};
    return out;
}

/// Returns both meshes as one.
Mesh joined(Mesh a, const Mesh& b) {
    const auto first = static_cast<std::uint32_t>(a.positions.size());
    a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
    a.normals.insert(a.normals.end(), b.normals.begin(), b.normals.end());
    for (const glm::uvec3& triangle : b.triangles) a.triangles.push_back(triangle + first);
    return a;
}

ConvexBodies bodies_of(const WorldGeometry& geometry) {
    return {geometry, std::vector<std::uint8_t>(geometry.ranges.size(), 1)};
}

}  // namespace

TEST_CASE(
    "convex bodies have no vertex above their triangles, and no triangle of another range touches their "
    "box") {
    const Mesh ball = make_sphere({0, 0, 0}, 1, 0.1), other = make_sphere({0.5, 0, 0}, 1, 0.1);
    const Mesh small = make_sphere({0.2, 0, 0}, 0.3, 0.1), far = make_sphere({3, 0, 0}, 1, 0.1);
    const Mesh cube = make_cube();
    Mesh upper = cube, with_a_line = ball;
    for (glm::vec3& position : upper.positions) position.y += 2;
    with_a_line.triangles.push_back({0, 0, 1});
    const struct {
        const char* what;
        std::vector<Mesh> meshes;
        bool convex;
    } cases[] = {{"alone", {ball}, true},
                 {"beside another one", {ball, far}, true},
                 {"around another one", {ball, small}, false},
                 {"through another one", {ball, other}, false},
                 {"with a triangle without an area", {with_a_line}, true},
                 {"two in one mesh", {joined(ball, far)}, false},
                 {"on a floor", {ball, floor_at(-1.001F)}, true},
                 {"cube", {cube}, true},
                 {"cube on a floor at its base", {cube, floor_at(-1)}, false},
                 {"stacked cubes", {cube, upper}, false},
                 {"cut by a floor whose vertices are far", {ball, floor_at(-0.5F)}, false}};
    for (const auto& [what, meshes, convex] : cases) {
        CAPTURES(what);
        WorldGeometry geometry;
        for (const Mesh& mesh : meshes) add(geometry, mesh);
        CHECK(bodies_of(geometry).has(0) == convex);
    }
    WorldGeometry geometry;
    add(geometry, ball);
    CHECK_FALSE(ConvexBodies(geometry, std::vector<std::uint8_t>(1, 0)).has(0));
    CHECK_FALSE(ConvexBodies().has(0));
}

TEST_CASE("rays leave a convex body at the triangle that they meet first, if walks are short") {
    for (const double scale : {1.0, 1e-3, 300.0}) {
        WorldGeometry geometry;
        add(geometry, make_sphere(scale * glm::dvec3(1, 2, 9), scale, 0.1));
        const auto first = static_cast<std::uint32_t>(geometry.triangles.size());
        add(geometry, make_sphere(scale * glm::dvec3(1, 2, 3), scale, 0.2));
        const ConvexBodies bodies = bodies_of(geometry);
        REQUIRE(bodies.has(1));
        const RaySurface surfaces[] = {{.positions = geometry.positions, .triangles = geometry.triangles}};
        const RayScene rays(surfaces);
        std::size_t found = 0, all = 0;
        for (std::uint32_t start = first; start + kLanes < geometry.triangles.size(); start += 7 * kLanes) {
            LaneVectors origins, directions;
            std::array<std::uint32_t, kLanes> triangles;
            std::array<std::optional<RayHit>, kLanes> hits;
            for (std::size_t i = 0; i < kLanes; ++i) {
                const glm::uvec3& corners = geometry.triangles[start + i];
                const glm::vec3 middle = (geometry.positions[corners.x] + geometry.positions[corners.y] +
                                          geometry.positions[corners.z]) /
                                         3.0F;
                const float angle = 1.3F * static_cast<float>(start + i);
                const auto size = static_cast<float>(scale);
                const glm::vec3 to =
                    size * (glm::vec3(1, 2, 3) + 0.6F * glm::vec3(std::cos(angle), std::sin(angle), 0.4F));
                const glm::vec3 direction = glm::normalize(to - middle);
                const glm::vec3 origin = middle + 1e-4F * size * direction;
                put(origins, i, origin);
                put(directions, i, direction);
                hits[i] = rays.intersect({.origin = origin, .direction = direction});
                REQUIRE(hits[i]);
                // Triangles that follow one another are mostly neighbours.
                triangles[i] = hits[i]->triangle + (i % 3 == 0 || hits[i]->triangle == first ? 0U : ~0U);
            }
            constexpr std::uint32_t some = 0xfff7;
            LaneTriangles at;
            LaneMeetings where;
            const std::uint32_t met = bodies.leave(1, origins, directions, some, triangles, at, where);
            CHECK((met & ~some) == 0);
            found += static_cast<std::size_t>(std::popcount(met));
            all += static_cast<std::size_t>(std::popcount(some));
            const LaneTriangles same = LaneTriangles::of(geometry, triangles);
            for (std::size_t i = 0; i < kLanes; ++i) {
                if ((met >> i & 1) == 0) continue;
                CAPTURES(start, i);
                CHECK(vector_at(at.corners[1], i) == vector_at(same.corners[1], i));
                CHECK(vector_at(at.normals[2], i) == vector_at(same.normals[2], i));
                CHECK(where.distances[i] == doctest::Approx(hits[i]->distance).epsilon(1e-4));
                const float b1 = where.b1[i], b2 = where.b2[i];
                const glm::vec3 place = (1 - b1 - b2) * vector_at(at.corners[0], i) +
                                        b1 * vector_at(at.corners[1], i) + b2 * vector_at(at.corners[2], i);
                const glm::vec3 on_ray =
                    vector_at(origins, i) + where.distances[i] * vector_at(directions, i);
                CHECK(glm::distance(place, on_ray) < 1e-5 * scale);
            }
        }
        CHECK(found > all * 3 / 4);
    }
}
