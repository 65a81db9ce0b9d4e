// SPDX-License-Identifier: MIT
#include "geometry/graded_mesh.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include "measures.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

/// Returns a floor of this size, with texture coordinates and colours.
Mesh floor_of(double size) {
    Mesh floor = transformed(make_rectangle(1), glm::scale(glm::dmat4(1), glm::dvec3(size)));
    for (const glm::vec3& p : floor.positions)
        floor.colors.push_back(0.5F + 0.5F * p / static_cast<float>(size));
    floor.face_colors = {{1, 0, 0}, {0, 1, 0}};
    return floor;
}

double longest(const Mesh& mesh, const glm::uvec3& t) {
    double most = 0;
    for (glm::length_t k = 0; k < 3; ++k)
        most = std::max(most, glm::distance(glm::dvec3(mesh.positions[t[k]]),
                                            glm::dvec3(mesh.positions[t[(k + 1) % 3]])));
    return most;
}

/// Returns the length of the longest edge of the triangles within a distance of the origin.
double longest_near(const Mesh& mesh, double distance) {
    double most = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        double nearest = 1e300;
        for (glm::length_t k = 0; k < 3; ++k)
            nearest = std::min(nearest, glm::length(glm::dvec3(mesh.positions[t[k]])));
        if (nearest < distance) most = std::max(most, longest(mesh, t));
    }
    return most;
}

}  // namespace

TEST_CASE("a floor is divided beside a ball far smaller than the floor, and stays the same surface") {
    for (const double size : {1e4, 1e6, 1e9}) {
        CAPTURE(size);
        const Mesh floor = floor_of(size);
        const Ball balls[] = {{.centre = {0, 0, 1}, .radius = 1}};
        const auto divided = graded(floor, balls);
        REQUIRE(divided);
        CHECK(divided->positions.size() < 400);
        CHECK(longest_near(*divided, 32) <= 2 * 64.01);  // neighbours may be twice as large
        CHECK(area(*divided) == doctest::Approx(area(floor)).epsilon(1e-6));
        REQUIRE(divided->colors.size() == divided->positions.size());
        REQUIRE(divided->face_colors.size() == divided->triangles.size());
        REQUIRE(divided->texcoord_triangles.size() == divided->triangles.size());
        for (std::size_t v = 0; v < divided->positions.size(); ++v) {
            const glm::vec3 p = divided->positions[v] / static_cast<float>(size);
            CHECK(p.z == 0);
            CHECK(glm::distance(divided->normals[v], glm::vec3(0, 0, 1)) < 1e-6F);
            CHECK(glm::distance(divided->colors[v], 0.5F + 0.5F * p) < 1e-6F);
        }
        for (std::size_t i = 0; i < divided->triangles.size(); ++i) {
            for (glm::length_t k = 0; k < 3; ++k) {
                const glm::vec3 p = divided->positions[divided->triangles[i][k]] / static_cast<float>(size);
                const glm::vec2 uv = divided->texcoords[divided->texcoord_triangles[i][k]];
                CHECK(glm::distance(uv, 0.5F + 0.5F * glm::vec2(p)) < 1e-6F);
            }
        }
    }
}

TEST_CASE("floors are divided for objects that are small and near, and for no others") {
    const Mesh floor = floor_of(1e5);
    const MeshExtent extent = extent_of(floor);
    const auto beside = [&](const MeshExtent& other) {
        return Details(std::array{extent, other}).beside(extent);
    };
    const auto ball = [](const glm::vec3& centre, float radius) {
        const Ball at{.centre = centre, .radius = radius};
        return MeshExtent{.ball = at, .detail = at, .longest = radius};
    };
    CHECK(beside(ball({0, 0, 1}, 1)).size() == 1);
    CHECK(beside(ball({0, 0, 1}, 1000)).empty());  // not small
    CHECK(beside(ball({0, 0, 1e7F}, 1)).empty());  // not near
    CHECK(!graded(floor, std::array{Ball{.centre = {0, 0, 5000}, .radius = 1}}));
    CHECK(graded(floor, std::array{Ball{.centre = {1e5F, 1e5F, 0}, .radius = 1}}));
    // A triangle beside the corner of the floor is nearer than any point of its plane.
    CHECK(!graded(floor, std::array{Ball{.centre = {1.1e5F, 1.1e5F, 0}, .radius = 1}}));
}

TEST_CASE("a mesh with triangles of all sizes is divided for its own small ones") {
    Mesh both = floor_of(1e6);
    both.colors.clear();
    both.face_colors.clear();
    both.texcoords.clear();
    both.texcoord_triangles.clear();
    const Mesh ball = make_sphere({0, 0, 1}, 1);
    const auto first = static_cast<std::uint32_t>(both.positions.size());
    both.positions.insert(both.positions.end(), ball.positions.begin(), ball.positions.end());
    both.normals.insert(both.normals.end(), ball.normals.begin(), ball.normals.end());
    for (const glm::uvec3& t : ball.triangles) both.triangles.push_back(t + first);
    const MeshExtent extent = extent_of(both);
    CHECK(extent.detail.radius < 2);
    const std::vector<Ball> details = Details(std::span(&extent, 1)).beside(extent);
    REQUIRE(details.size() == 1);
    const auto divided = graded(both, details);
    REQUIRE(divided);
    CHECK(longest_near(*divided, 32) <= 2 * 64.01);
    // A mesh of triangles of one size has no details.
    const MeshExtent even = extent_of(ball);
    CHECK(even.detail == even.ball);
    CHECK(Details(std::span(&even, 1)).beside(even).empty());
}
