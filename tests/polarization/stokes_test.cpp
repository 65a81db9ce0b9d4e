// SPDX-License-Identifier: MIT
#include "polarization/stokes.hpp"

#include "test.hpp"

using namespace nicol;
using doctest::Approx;

namespace {

// Returns the Stokes vector of linear light whose field is at `angle` from x, by definition: s1 and s2 are
// differences of intensities behind polarizers.
Stokes linear_light(double angle) {
    const auto behind = [angle](double polarizer) { return std::pow(std::cos(angle - polarizer), 2); };
    return {1, behind(0) - behind(pi / 2), behind(pi / 4) - behind(-pi / 4), 0};
}

}  // namespace

TEST_CASE("rotating the frame by psi subtracts psi from the angle of polarization") {
    for_all({0.0, 0.3, 1.2, -0.7}, {0.0, 0.5, -1.1, pi / 2}, [&](double angle, double psi) {
        const Stokes expected = linear_light(angle - psi);
        CHECK(glm::distance(rotated(linear_light(angle), psi), expected) < 1e-15);
    });
    CHECK(rotated({1, .2, .3, .4}, .8)[3] == .4);
    CHECK(rotated({1, .2, .3, .4}, .8)[0] == 1);
}

TEST_CASE("angle_between recovers the rotation with its sign") {
    const Frame frame = theta_phi_frame(glm::normalize(glm::dvec3(1, 2, -3)));
    for (const double psi : {0.0, 0.4, -0.4, 2.0, -3.0}) {
        const Frame to(std::cos(psi) * frame[0] + std::sin(psi) * frame[1],
                       std::cos(psi) * frame[1] - std::sin(psi) * frame[0], frame[2]);
        CHECK(angle_between(frame, to) == Approx(psi));
    }
}

TEST_CASE("theta-phi frames are right-handed and orthonormal everywhere, poles included") {
    for (const glm::dvec3 d :
         {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0),
          glm::normalize(glm::dvec3(1e-200, 0, 1)), glm::normalize(glm::dvec3(-1, 2, .5))}) {
        const Frame f = theta_phi_frame(d);
        CHECK(glm::determinant(f) == Approx(1));
        CHECK(glm::distance(glm::cross(f[0], f[1]), d) < 1e-15);
        CHECK(glm::dot(f[0], d) == Approx(0));
        CHECK(f[2] == d);
    }
    // theta-hat points away from the north pole, and phi-hat counter-clockwise around it.
    CHECK(theta_phi_frame({1, 0, 0})[0].z == -1);
    CHECK(theta_phi_frame({1, 0, 0})[1].y == 1);
    // phi is 0 at the poles, as in the limit along the x axis.
    CHECK(theta_phi_frame({0, 0, 1})[0] == glm::dvec3(1, 0, 0));
    CHECK(theta_phi_frame({0, 0, -1})[0] == glm::dvec3(-1, 0, 0));
}

TEST_CASE("frame_with_x keeps z and leans x towards the hint") {
    const glm::dvec3 z = glm::normalize(glm::dvec3(1, 2, 3));
    const Frame f = frame_with_x(z, {1, 0, 0});
    CHECK(glm::determinant(f) == Approx(1));
    CHECK(f[2] == z);
    CHECK(f[0].x > 0);
    CHECK(glm::dot(f[1], glm::dvec3(1, 0, 0)) == Approx(0));
}
