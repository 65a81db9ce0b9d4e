// SPDX-License-Identifier: MIT
// Tests of discs and cylinders.
#include <glm/vec2.hpp>

#include "geometry/measures.hpp"
#include "geometry/mesh.hpp"
#include "test.hpp"

using nicol::Mesh;

namespace {

glm::dvec3 face_normal(const Mesh& mesh, const glm::uvec3& t) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    return glm::normalize(glm::cross(b - a, c - a));
}

/// Returns the texture coordinates at a surface point, from the triangle whose plane contains it.
glm::dvec2 texcoords_at(const Mesh& mesh, const glm::dvec3& point) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        glm::dmat3 p;
        for (glm::length_t k = 0; k < 3; ++k) p[k] = glm::dvec3(mesh.positions[mesh.triangles[i][k]]);
        const glm::dvec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
        if (std::abs(glm::dot(point - p[0], glm::normalize(n))) > 1e-3) continue;
        glm::dvec3 weight;
        for (glm::length_t k = 0; k < 3; ++k)
            weight[k] = glm::dot(n, glm::cross(p[(k + 2) % 3] - p[(k + 1) % 3], point - p[(k + 1) % 3])) /
                        glm::dot(n, n);
        if (std::min({weight.x, weight.y, weight.z}) < -1e-3) continue;
        glm::dvec2 uv(0);
        for (glm::length_t k = 0; k < 3; ++k)
            uv += weight[k] * glm::dvec2(mesh.texcoords.at(mesh.texcoord_triangles.at(i)[k]));
        return uv;
    }
    FAIL("no triangle is there");
    return {};
}

}  // namespace

TEST_CASE("a disc is round and faces +z") {
    Mesh mesh = nicol::make_disk();
    CHECK(mesh.positions.size() == 180 * 16 + 1);
    for (const glm::uvec3& t : mesh.triangles) CHECK(face_normal(mesh, t).z == doctest::Approx(1));
    CHECK(area(mesh) == doctest::Approx(pi).epsilon(3e-4));
    CHECK(nicol::validate(mesh, "disc") == 0);
}

TEST_CASE("a cylinder is open, and its front is outside") {
    const glm::dvec3 p0(1, 2, 3), p1(2, 4, 5);
    Mesh mesh = nicol::make_cylinder(p0, p1, 0.5);
    const glm::dvec3 axis = glm::normalize(p1 - p0);
    const auto across = [&](const glm::dvec3& v) { return v - glm::dot(v, axis) * axis; };
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 out = across(glm::dvec3(mesh.positions[i]) - p0);
        CHECK(glm::length(out) == doctest::Approx(0.5));
        CHECK(glm::distance(out / 0.5, glm::dvec3(mesh.normals[i])) < 1e-5);
    }
    for (const glm::uvec3& t : mesh.triangles)
        CHECK(glm::dot(face_normal(mesh, t), glm::dvec3(mesh.normals[t.x])) > 0.999);
    CHECK(area(mesh) == doctest::Approx(pi * 3).epsilon(1e-3));
    CHECK(nicol::validate(mesh, "cylinder") == 0);
}

TEST_CASE("texture coordinates of discs and cylinders are Mitsuba's, across the seam too") {
    struct Row {
        glm::dvec3 point;
        glm::dvec2 uv;
    };
    // The expected values come from mitsuba.Scene.ray_intersect.
    const Mesh disc = nicol::make_disk();
    for (const auto& [point, uv] :
         {Row{{0, 0.5, 0}, {0.5, 0.25}}, Row{{-0.5, 0, 0}, {0.5, 0.5}}, Row{{0, -0.5, 0}, {0.5, 0.75}},
          Row{{0.6, 0.6, 0}, {0.8485, 0.125}}, Row{{0.1, -0.3, 0}, {0.3162, 0.8012}}}) {
        CAPTURE(point.x);
        CHECK(glm::distance(texcoords_at(disc, point), uv) < 2e-3);
    }
    const Mesh cylinder = nicol::make_cylinder({1, 2, 3}, {2, 4, 5}, 0.5);
    for (const auto& [point, uv] :
         {Row{{1.7077, 2.4703, 3.3009}, {0.0159, 0.25}}, Row{{1.446, 2.7725, 3.1295}, {0.1592, 0.25}},
          Row{{0.9954, 2.2661, 3.8612}, {0.6366, 0.25}}, Row{{1.7167, 2.3335, 3.4331}, {0.9549, 0.25}}}) {
        CAPTURE(point.x);
        CHECK(glm::distance(texcoords_at(cylinder, point), uv) < 2e-3);
    }
    for (const Mesh& mesh : {disc, cylinder})
        for (const glm::uvec3& t : mesh.texcoord_triangles)
            for (glm::length_t axis = 0; axis < 2; ++axis) {
                const auto [least, most] = std::minmax(
                    {mesh.texcoords[t.x][axis], mesh.texcoords[t.y][axis], mesh.texcoords[t.z][axis]});
                CHECK(most - least < 0.1F);
            }
}

TEST_CASE("cylinders that are none are refused") {
    const double nan = std::nan("");
    for (const double radius : {0.0, -1.0, nan, HUGE_VAL})
        CHECK_THROWS_AS(nicol::make_cylinder({0, 0, 0}, {0, 0, 1}, radius), nicol::Error);
    CHECK_THROWS_AS(nicol::make_cylinder({1, 2, 3}, {1, 2, 3}, 1), nicol::Error);
    CHECK_THROWS_AS(nicol::make_cylinder({nan, 0, 0}, {0, 0, 1}, 1), nicol::Error);
}
