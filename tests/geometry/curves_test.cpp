// SPDX-License-Identifier: MIT
#include <glm/geometric.hpp>

#include "error.hpp"
#include "geometry/mesh.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

Mesh curves(CurveKind kind, const std::string& text) {
    const TemporaryFolder folder;
    return load_curves(folder.write("a.txt", text), kind);
}

/// Checks that triangles face where normals do.
void check_winding(const Mesh& mesh) {
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3 a = mesh.positions[t.x];
        const glm::vec3 across = glm::cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a);
        REQUIRE(glm::dot(across, mesh.normals[t.x] + mesh.normals[t.y] + mesh.normals[t.z]) > 0);
    }
    REQUIRE(mesh.texcoord_triangles.size() == mesh.triangles.size());
}

}  // namespace

TEST_CASE("a B-spline curve is a tube whose radius its points give, and v grows along it") {
    // Even steps of a straight line and of the radius stay even: z from 1 to 3, the radius from .2 to .4.
    const Mesh cone = curves(CurveKind::bspline, "0 0 0 0.1\n0 0 1 0.2\n0 0 2 0.3\n0 0 3 0.4\n0 0 4 0.5\n");
    check_winding(cone);
    float low = 9, high = 0;
    for (std::size_t i = 0; i < cone.positions.size(); ++i) {
        const glm::vec3& at = cone.positions[i];
        CHECK(glm::length(glm::vec2(at)) == doctest::Approx(0.1 + 0.1 * at.z).epsilon(1e-5));
        // The normal of a cone that widens by 0.1 a unit of length.
        CHECK(cone.normals[i].z == doctest::Approx(-0.1 / std::sqrt(1.01)).epsilon(1e-4));
        low = std::min(low, at.z);
        high = std::max(high, at.z);
    }
    CHECK(low == doctest::Approx(1));
    CHECK(high == doctest::Approx(3));
    for (std::size_t t = 0; t < cone.triangles.size(); ++t)
        for (glm::length_t k = 0; k < 3; ++k)
            CHECK(cone.texcoords[cone.texcoord_triangles[t][k]].y ==
                  doctest::Approx((cone.positions[cone.triangles[t][k]].z - 1) / 2).epsilon(1e-4));

    // The middle of four points at the corners of a square is (p0 + 23 p1 + 23 p2 + p3) / 48.
    const Mesh bent = curves(CurveKind::bspline, "0 0 0 0.1\n0 0 1 0.1\n1 0 1 0.1\n1 0 0 0.1\n");
    check_winding(bent);
    const glm::vec3 middle(0.5F, 0, 46.0F / 48);
    CHECK(std::ranges::count_if(bent.positions, [&](const glm::vec3& at) {
              return std::abs(glm::distance(at, middle) - 0.1F) < 1e-5F;
          }) == 48);
}

TEST_CASE("linear curves join straight tubes by balls, and empty lines part them") {
    const Mesh mesh = curves(CurveKind::linear, "\n0 0 0 0.1\n0 0 1 0.1\n1 0 1 0.1\n\n\n5 0 0 1\n5 0 3 1\n");
    check_winding(mesh);
    for (const glm::vec3& at : mesh.positions) {
        const auto from = [&](const glm::vec3& a, const glm::vec3& b) {
            const float t = glm::clamp(glm::dot(at - a, b - a) / glm::dot(b - a, b - a), 0.0F, 1.0F);
            return glm::distance(at, a + t * (b - a));
        };
        const float near = std::min(from({0, 0, 0}, {0, 0, 1}), from({0, 0, 1}, {1, 0, 1}));
        const float wide = from({5, 0, 0}, {5, 0, 3});
        // Points of a ball may lie inside the tubes.
        CHECK((near < 0.1001F || wide < 1.0001F));
    }
}

TEST_CASE("files that hold no curves are refused with the line") {
    const struct {
        CurveKind kind;
        const char* text;
        const char* message;
    } rows[] = {{CurveKind::linear, "", "no curve"},
                {CurveKind::linear, "0 0 0 1\n", "a curve of 1 points ends; expected at least 2"},
                {CurveKind::bspline, "0 0 0 1\n0 0 1 1\n0 0 2 1\n\n", "expected at least 4"},
                {CurveKind::linear, "0 0 0 1\n0 0 1\n", ":2: "},
                {CurveKind::linear, "0 0 0 1\n0 0 1 0\n", "the radius is not above 0"},
                {CurveKind::linear, "0 0 0 1\n0 0 1 nan\n", "a radius"},
                {CurveKind::linear, "0 0 0 1 7\n0 0 1 1\n", "more than x, y, z and a radius"}};
    for (const auto& row : rows)
        check_error(
            ErrorCode::invalid_file, [&] { static_cast<void>(curves(row.kind, row.text)); }, "a.txt",
            row.message);
}
