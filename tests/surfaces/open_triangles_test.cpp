// SPDX-License-Identifier: MIT
#include "surfaces/open_triangles.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/ray_scene.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

struct Triangles {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> corners;

    /// Adds a sphere; returns the number of its first triangle.
    std::size_t add_sphere(const glm::dvec3& center, double radius) {
        const Mesh mesh = make_sphere(center, radius, 0.1);
        const auto first = static_cast<std::uint32_t>(positions.size());
        const std::size_t out = corners.size();
        positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
        for (const glm::uvec3& triangle : mesh.triangles) corners.push_back(triangle + first);
        return out;
    }

    /// Returns the largest height of a vertex above a triangle.
    [[nodiscard]] double highest_above(const glm::uvec3& of) const {
        const glm::dvec3 a(positions[of.x]), b(positions[of.y]), c(positions[of.z]);
        const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
        double out = 0;
        for (const glm::vec3& p : positions) out = std::max(out, glm::dot(normal, glm::dvec3(p) - a));
        return out;
    }
};

}  // namespace

TEST_CASE("the triangles of a convex body alone are open, and those that face another body are not") {
    for (const glm::dvec3 middle : {glm::dvec3(0.0), glm::dvec3(1000, -300, 50)}) {
        Triangles scene;
        scene.add_sphere(middle, 1);
        const std::size_t count = scene.corners.size();
        const OpenTriangles alone(scene.positions);
        for (const glm::uvec3& triangle : scene.corners) CHECK(alone.open(triangle));

        scene.add_sphere(middle + glm::dvec3(0, 3, 0), 0.5);
        const OpenTriangles both(scene.positions);
        std::size_t open = 0;
        for (const glm::uvec3& triangle : std::span(scene.corners).first(count)) {
            const double highest = scene.highest_above(triangle);
            // Rays start this far above the triangle.
            const double offset = ray_offset(
                {scene.positions[triangle.x], scene.positions[triangle.y], scene.positions[triangle.z]});
            CHECK(both.open(triangle) == (highest <= 0.5 * offset));
            if (both.open(triangle)) ++open;
        }
        CHECK(open > count / 4);
        CHECK(open < count * 3 / 4);
    }
}

TEST_CASE("the back of a triangle and far vertices count, and a triangle without an area is not open") {
    // A roof above the ground, seen from above and from below.
    const std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0},     {0, 1, 0},     {0, 0, 1}, {1, 0, 1},
                                           {0, 1, 1}, {1e6F, 0, -2}, {0, 1e6F, -2}, {0, 0, -2}};
    const OpenTriangles triangles(positions);
    CHECK_FALSE(triangles.open({0, 1, 2}));
    CHECK_FALSE(triangles.open({0, 2, 1}));  // the far triangle lies below
    CHECK(triangles.open({3, 4, 5}));
    CHECK_FALSE(triangles.open({3, 5, 4}));
    CHECK_FALSE(triangles.open({3, 4, 4}));
    CHECK(triangles.open({6, 8, 7}));
}
