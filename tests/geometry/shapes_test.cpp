// SPDX-License-Identifier: MIT
// Tests of spheres, rectangles and cubes.
#include <map>

#include "geometry/measures.hpp"
#include "geometry/mesh.hpp"
#include "test.hpp"

using nicol::Mesh;

namespace {

/// Returns whether every edge has one face on either side, in opposite directions.
bool is_closed(const Mesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const glm::uvec3& t : mesh.triangles)
        for (glm::length_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
    return std::ranges::all_of(edges, [&](const auto& edge) {
        const auto opposite = edges.find({edge.first.second, edge.first.first});
        return edge.second == 1 && opposite != edges.end();
    });
}

glm::vec3 face_normal(const Mesh& mesh, const glm::uvec3& t) {
    return glm::normalize(
        glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]));
}

}  // namespace

TEST_CASE("a sphere is closed, even and exact at its vertices") {
    Mesh mesh = nicol::make_sphere();
    CHECK(mesh.positions.size() == 14442);
    CHECK(mesh.triangles.size() == 28880);
    CHECK(is_closed(mesh));
    CHECK_NOTHROW(nicol::validate(mesh, "sphere"));
    double longest = 0.0;
    double shortest = 10.0;
    double depth = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        CHECK(glm::dot(face_normal(mesh, t), mesh.positions[t.x]) > 0.99f);
        for (glm::length_t i = 0; i < 3; ++i) {
            const double chord =
                glm::distance(glm::dvec3(mesh.positions[t[i]]), glm::dvec3(mesh.positions[t[(i + 1) % 3]]));
            longest = std::max(longest, chord);
            shortest = std::min(shortest, chord);
        }
        const glm::dvec3 a(mesh.positions[t.x]);
        const glm::dvec3 normal = glm::normalize(
            glm::cross(glm::dvec3(mesh.positions[t.y]) - a, glm::dvec3(mesh.positions[t.z]) - a));
        depth = std::max(depth, 1.0 - glm::dot(normal, a));
    }
    // The header promises these bounds.
    CHECK(2.0 * std::asin(longest / 2.0) * 180.0 / pi <= 2.0);
    CHECK(depth <= 2.1e-4);
    CHECK(longest / shortest < 1.7);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        CHECK(std::abs(glm::length(mesh.positions[v]) - 1.0f) < 1e-6f);
        CHECK(glm::distance(mesh.positions[v], mesh.normals[v]) < 1e-6f);
    }
    for (glm::length_t axis = 0; axis < 3; ++axis)
        for (const float sign : {1.0f, -1.0f}) {
            glm::vec3 point(0.0f);
            point[axis] = sign;
            CHECK(std::ranges::count(mesh.positions, point) == 1);
        }
}

TEST_CASE("interpolation over the sphere errs as little as promised") {
    const Mesh mesh = nicol::make_sphere();
    // cos(l phi) sin^l(theta) is the harmonic of order l with the largest curvature.
    for (const int l : {2, 4, 8, 16}) {
        const auto f = [l](const glm::dvec3& p) {
            return std::pow(std::hypot(p.x, p.y), l) * std::cos(l * std::atan2(p.y, p.x));
        };
        double worst = 0.0;
        for (const glm::uvec3& t : mesh.triangles) {
            const glm::dvec3 a(mesh.positions[t.x]);
            const glm::dvec3 b(mesh.positions[t.y]);
            const glm::dvec3 c(mesh.positions[t.z]);
            for (const glm::dvec3 w :
                 {glm::dvec3(1, 1, 1) / 3.0, glm::dvec3(0.5, 0.5, 0), glm::dvec3(0, 0.5, 0.5)}) {
                const double interpolated = w.x * f(a) + w.y * f(b) + w.z * f(c);
                worst =
                    std::max(worst, std::abs(interpolated - f(glm::normalize(w.x * a + w.y * b + w.z * c))));
            }
        }
        CAPTURE(l);
        CHECK(worst <= 1.6e-4 * l * l);
    }
}

TEST_CASE("a sphere elsewhere and of another size") {
    const Mesh mesh = nicol::make_sphere(glm::dvec3(1, 2, 3), 0.25);
    for (const glm::vec3& p : mesh.positions)
        CHECK(glm::distance(p, glm::vec3(1, 2, 3)) == doctest::Approx(0.25));
    const double nan = std::nan("");
    CHECK_THROWS_AS(nicol::make_sphere(glm::dvec3(0.0), 0.0), nicol::Error);
    CHECK_THROWS_AS(nicol::make_sphere(glm::dvec3(0.0), -1.0), nicol::Error);
    CHECK_THROWS_AS(nicol::make_sphere(glm::dvec3(0.0), nan), nicol::Error);
    CHECK_THROWS_AS(nicol::make_sphere(glm::dvec3(nan, 0, 0), 1.0), nicol::Error);
}

TEST_CASE("texture coordinates of a sphere are its angles, across the seam and at the poles too") {
    const Mesh mesh = nicol::make_sphere({1, 2, 3}, 2);
    REQUIRE(mesh.texcoord_triangles.size() == mesh.triangles.size());
    int seam = 0, poles = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        std::array<glm::dvec2, 3> uv;
        for (glm::length_t k = 0; k < 3; ++k)
            uv[static_cast<std::size_t>(k)] = mesh.texcoords.at(mesh.texcoord_triangles[i][k]);
        double least = 9, most = -9;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 n(mesh.normals[mesh.triangles[i][static_cast<glm::length_t>(k)]]);
            CHECK(uv[k].y == doctest::Approx(std::acos(n.z) / pi).epsilon(1e-4));
            least = std::min(least, uv[k].x);
            most = std::max(most, uv[k].x);
            if (n.x == 0 && n.y == 0) {
                ++poles;
                CHECK(uv[k].x == doctest::Approx((uv[(k + 1) % 3].x + uv[(k + 2) % 3].x) / 2));
                continue;
            }
            CHECK(std::sin(2 * pi * uv[k].x) == doctest::Approx(n.y / std::hypot(n.x, n.y)).epsilon(1e-3));
            CHECK(std::cos(2 * pi * uv[k].x) == doctest::Approx(n.x / std::hypot(n.x, n.y)).epsilon(1e-3));
        }
        // No triangle spans the image in the wrong direction.
        CHECK(most - least <= 0.5);
        CHECK(least >= 0);
        if (most > 1) ++seam;
    }
    CHECK(poles == 12);
    CHECK(seam > 20);
}

TEST_CASE("a rectangle is the square [-1, 1]^2 facing +z") {
    for (const int cells : {1, 7, 64}) {
        Mesh mesh = nicol::make_rectangle(cells);
        const auto side = static_cast<std::size_t>(cells + 1);
        CHECK(mesh.positions.size() == side * side);
        CHECK_NOTHROW(nicol::validate(mesh, "rectangle"));
        for (const glm::uvec3& t : mesh.triangles) {
            CHECK(glm::distance(face_normal(mesh, t), glm::vec3(0, 0, 1)) < 1e-5f);
        }
        CHECK(area(mesh) == doctest::Approx(4.0));
        CHECK(mesh.texcoord_triangles == mesh.triangles);
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            CHECK(glm::distance(2.0F * mesh.texcoords[v] - 1.0F, glm::vec2(mesh.positions[v])) < 1e-6F);
        for (const float x : {-1.0f, 1.0f})
            for (const float y : {-1.0f, 1.0f})
                CHECK(std::ranges::count(mesh.positions, glm::vec3(x, y, 0)) == 1);
    }
    for (const int cells : {0, -1, 1025, 2147483647})
        CHECK_THROWS_AS(nicol::make_rectangle(cells), nicol::Error);
}

TEST_CASE("a cube is [-1, 1]^3 with hard edges") {
    Mesh mesh = nicol::make_cube(4);
    CHECK(mesh.positions.size() == 6 * 25);
    CHECK(mesh.triangles.size() == 6 * 32);
    CHECK_NOTHROW(nicol::validate(mesh, "cube"));
    for (const glm::uvec3& t : mesh.triangles) {
        CHECK(glm::distance(face_normal(mesh, t), mesh.normals[t.x]) < 1e-5f);
        CHECK(glm::dot(mesh.normals[t.x], mesh.positions[t.x]) == 1.0f);
    }
    CHECK(volume(mesh) == doctest::Approx(8.0));
    CHECK(std::ranges::count(mesh.positions, glm::vec3(1, 1, 1)) == 3);
    CHECK_THROWS_AS(nicol::make_cube(0), nicol::Error);
}

TEST_CASE("every side of a cube has the whole image, as Mitsuba's has it") {
    // Corners of each side in Mitsuba at the coordinates (0, 1), (1, 1), (1, 0) and (0, 0).
    const std::array<std::array<glm::vec3, 4>, 6> sides = {
        {{{{1, -1, -1}, {1, -1, 1}, {-1, -1, 1}, {-1, -1, -1}}},
         {{{1, 1, -1}, {-1, 1, -1}, {-1, 1, 1}, {1, 1, 1}}},
         {{{1, -1, -1}, {1, 1, -1}, {1, 1, 1}, {1, -1, 1}}},
         {{{1, -1, 1}, {1, 1, 1}, {-1, 1, 1}, {-1, -1, 1}}},
         {{{-1, -1, 1}, {-1, 1, 1}, {-1, 1, -1}, {-1, -1, -1}}},
         {{{1, 1, -1}, {1, -1, -1}, {-1, -1, -1}, {-1, 1, -1}}}}};
    const std::array<glm::vec2, 4> corners = {{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
    const Mesh mesh = nicol::make_cube();
    CHECK(mesh.texcoord_triangles == mesh.triangles);
    REQUIRE(mesh.texcoords.size() == 24);
    for (const auto& side : sides) {
        const glm::vec3 normal = 0.5F * (side[0] + side[2]);
        for (std::size_t k = 0; k < 4; ++k) {
            int found = 0;
            for (std::size_t v = 0; v < 24; ++v)
                if (mesh.positions[v] == side[k] && mesh.normals[v] == normal) {
                    ++found;
                    CHECK(mesh.texcoords[v] == corners[k]);
                }
            CHECK(found == 1);
        }
    }
    const Mesh fine = nicol::make_cube(8);
    for (std::size_t v = 0; v < 81; ++v)  // side +x
        CHECK(fine.texcoords[v] == glm::vec2((1 + fine.positions[v].y) / 2, (1 - fine.positions[v].z) / 2));
}
