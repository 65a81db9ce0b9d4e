// SPDX-License-Identifier: MIT
// Tests of the mapping between directions and image positions, and of its frames.
#include "light/equirect.hpp"

#include "light/images.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("coordinates of the axes") {
    CHECK(equirect_coordinates({0, 1, 0}) == glm::dvec2(0, 0));
    CHECK(equirect_coordinates({0, -1, 0}) == glm::dvec2(0, 1));
    CHECK(equirect_coordinates({0, 0, -1}) == glm::dvec2(0, 0.5));
    CHECK(equirect_coordinates({1, 0, 0}) == glm::dvec2(0.25, 0.5));
    CHECK(equirect_coordinates({0, 0, 1}) == glm::dvec2(0.5, 0.5));
    CHECK(equirect_coordinates({-1, 0, 0}) == glm::dvec2(0.75, 0.5));
    // Just left of the seam u is below 1, because no column has u = 1.
    CHECK(equirect_coordinates({-1e-300, 0, -1}).x < 1);
    CHECK(equirect_coordinates({-1e-300, 0, -1}).x >= 0);
}

TEST_CASE("directions and coordinates undo each other") {
    for (const glm::dvec3& w : random_directions(200)) {
        const glm::dvec2 uv = equirect_coordinates(w);
        CHECK(glm::length(equirect_direction(uv.x, uv.y) - w) < 1e-15);
        CHECK(glm::length(towards(uv.x, uv.y) - w) < 1e-15);
    }
    // v keeps its precision near a pole.
    CHECK(equirect_coordinates(glm::normalize(glm::dvec3(1e-9, 1, 0))).y ==
          doctest::Approx(1e-9 / pi).epsilon(1e-12));
}

TEST_CASE("the image frame is right-handed, propagates to the scene, with x to increasing u and y up") {
    for (int i = 0; i < 20; ++i) {
        const double u = (i + 0.3) / 20;
        for (const double v : {0.1, 0.5, 0.93}) {
            const Frame frame = equirect_frame(u, v);
            const Frame expected = pixel_frame(u, v);
            for (int k = 0; k < 3; ++k) CHECK(glm::length(frame[k] - expected[k]) < 1e-9);
            CHECK(glm::determinant(frame) == doctest::Approx(1));
            CHECK(frame[1].y > 0);
        }
    }
}

TEST_CASE("the image frame is the theta-phi frame about y rotated by +90 degrees, so s1 and s2 change sign") {
    const glm::dmat3 axes = equirect_axes();
    CHECK(glm::determinant(axes) == doctest::Approx(1));
    for (int i = 0; i < 20; ++i) {
        const double u = (i + 0.3) / 20;
        const double v = (i + 1) / 22.0;
        // The propagation direction and its theta-phi frame, in axes whose pole is y.
        const glm::dvec3 local = glm::transpose(axes) * -equirect_direction(u, v);
        CHECK(std::acos(local.z) == doctest::Approx(pi * (1 - v)));
        CHECK(std::remainder(std::atan2(local.y, local.x) - (pi - 2 * pi * u), 2 * pi) == doctest::Approx(0));
        const Frame theta_phi = axes * theta_phi_frame(local);
        CHECK(angle_between(theta_phi, equirect_frame(u, v)) == doctest::Approx(pi / 2));
        const Stokes s = rotated({1, 0.3, 0.4, 0.1}, angle_between(theta_phi, equirect_frame(u, v)));
        CHECK(glm::length(s - Stokes(1, -0.3, -0.4, 0.1)) < 1e-15);
    }
}

TEST_CASE("a pixel's solid angle is the integral of the light that it alone makes") {
    for (const auto& [width, height] : {std::pair{8, 5}, {3, 2}, {16, 33}}) {
        CAPTURES(width, height);
        double sum = 0;
        for (int row = 0; row < height; ++row) {
            EquirectImage image(width, height, 1);
            image.at(0, row, 1)[0] = 1;
            const double expected = std::sqrt(4 * pi) * image_environment(image)->project(0).at(0, 0, 0, 0);
            CHECK(pixel_solid_angle(width, height, row) == doctest::Approx(expected).epsilon(1e-9));
            sum += width * pixel_solid_angle(width, height, row);
        }
        CHECK(sum == doctest::Approx(4 * pi).epsilon(1e-12));
    }
}
