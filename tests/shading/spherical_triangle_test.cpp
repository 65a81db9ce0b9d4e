// SPDX-License-Identifier: MIT
#include "shading/spherical_triangle.hpp"

#include <glm/matrix.hpp>

#include "directions.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("samples of a spherical triangle are uniform over its solid angle") {
    std::mt19937 random(3);
    for (int n = 0; n < 20; ++n) {
        CAPTURE(n);
        const glm::dvec3 a = random_direction(random);
        // From triangles of a hundredth of a steradian to large ones, at any distance.
        const double size = n % 2 == 0 ? 0.2 : 2;
        const std::array<glm::dvec3, 3> corners{a, 3.0 * (a + size * random_direction(random)),
                                                0.1 * (a + size * random_direction(random))};
        const SphericalTriangle triangle(corners);
        const glm::dmat3 to_corners = glm::inverse(glm::dmat3(corners[0], corners[1], corners[2]));
        // The solid angle is the excess of the angles (Girard), and the integral of the direction is the sum
        // over the edges of their arcs along their normals (Lambert).
        double excess = -pi;
        glm::dvec3 integral(0), sampled(0);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 &p = corners[k], &next = corners[(k + 1) % 3], &last = corners[(k + 2) % 3];
            const glm::dvec3 edge = glm::normalize(glm::cross(p, next));
            excess += std::acos(glm::dot(edge, glm::normalize(glm::cross(p, last))));
            integral += 0.5 * std::acos(glm::dot(glm::normalize(p), glm::normalize(next))) * edge;
        }
        if (glm::dot(integral, a) < 0) integral = -integral;
        CHECK(triangle.solid_angle() == doctest::Approx(excess).epsilon(1e-6));
        constexpr int side = 64;
        bool inside = true;
        for (int i = 0; i < side; ++i)
            for (int k = 0; k < side; ++k) {
                const glm::dvec3 d = triangle.sample((i + 0.5) / side, (k + 0.5) / side);
                sampled += d / static_cast<double>(side * side);
                const glm::dvec3 weights = to_corners * d;
                inside = inside && std::min({weights.x, weights.y, weights.z}) > -1e-6;
            }
        CHECK(inside);
        CHECK(glm::distance(sampled, integral / excess) < 2e-3 * size);
    }
}

TEST_CASE("a triangle that is seen edge on, or from its corner, has no solid angle") {
    CHECK(SphericalTriangle({glm::dvec3(1, 0, 0), {0, 1, 0}, {1, 1, 0}}).solid_angle() == 0);
    CHECK(SphericalTriangle({glm::dvec3(0), {0, 1, 0}, {1, 1, 0}}).solid_angle() == 0);
    const SphericalTriangle tiny({glm::dvec3(0, 0, 1), {1e-3, 0, 1}, {0, 1e-3, 1}});
    CHECK(tiny.solid_angle() == doctest::Approx(5e-7).epsilon(1e-4));
}
