// SPDX-License-Identifier: MIT
// Tests of states of polarization: their frames, and refusals.
#include "light/polarization_state.hpp"
#include "directions.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("a state's Stokes vector has its degrees and its angle") {
    for_all({0.0, 0.3, 0.8}, {-0.6, 0.0, 0.5}, {-1.0, 0.0, 0.4}, [](double dolp, double docp, double aolp) {
        const PolarizationState state{.dolp = dolp, .aolp = aolp, .docp = docp};
        const Stokes s = state.stokes();
        CHECK(s[0] == 1);
        CHECK(std::hypot(s[1], s[2]) == doctest::Approx(dolp));
        if (dolp > 0) CHECK(std::atan2(s[2], s[1]) / 2 == doctest::Approx(aolp));
        CHECK(s[3] == docp);
        CHECK(state.polarized() == (dolp > 0 || docp != 0));
        CHECK(state.circular() == (docp != 0));
    });
}

TEST_CASE("the frame of a state is orthonormal, along the light, with the axis on its x side") {
    const auto directions = random_directions(200, 3);
    for (std::size_t i = 0; i + 1 < directions.size(); i += 2) {
        const glm::dvec3 axis = 3.0 * directions[i];
        const glm::dvec3& propagation = directions[i + 1];
        const Frame frame = polarization_frame(axis, propagation);
        CHECK(largest_difference(glm::transpose(frame) * frame, glm::dmat3(1.0)) < 1e-14);
        CHECK(glm::determinant(frame) > 0);
        CHECK(frame[2] == propagation);
        CHECK(glm::dot(frame[0], axis) > 0);
        CHECK(std::abs(glm::dot(frame[1], axis)) < 1e-14);
        // The frame varies continuously with the propagation direction.
        const Frame near = polarization_frame(axis, glm::normalize(propagation + 1e-7 * directions[0]));
        CHECK(largest_difference(near, frame) < 1e-5);
    }
}

TEST_CASE("where the axis is parallel to the light, x is that of the theta-phi frame") {
    for (const glm::dvec3& propagation : random_directions(20, 4)) {
        for (const double length : {1.0, -2.0, 1e-5})
            CHECK(polarization_frame(length * propagation, propagation) == theta_phi_frame(propagation));
    }
}

TEST_CASE("a state is the same light in every frame") {
    const auto d = random_directions(3, 5);
    const PolarizationState state{.dolp = 0.6, .aolp = 0.4, .docp = -0.3, .axis = d[0]};
    const Frame own = polarization_frame(state.axis, d[1]);
    CHECK(glm::length(stokes_in(own, state, state.axis) - state.stokes()) < 1e-15);
    const Frame other = frame_with_x(d[1], d[2]);
    const Stokes s = stokes_in(other, state, state.axis);
    // Returns the direction in which the electric field is strongest.
    const auto strongest = [](const Frame& f, const Stokes& v) {
        const double angle = std::atan2(v[2], v[1]) / 2;
        return std::cos(angle) * f[0] + std::sin(angle) * f[1];
    };
    CHECK(std::abs(glm::dot(strongest(own, state.stokes()), strongest(other, s))) == doctest::Approx(1));
    CHECK(s[3] == state.docp);
    CHECK(std::hypot(s[1], s[2]) == doctest::Approx(state.dolp));
}

TEST_CASE("states that no light has are refused by name") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const struct {
        PolarizationState state;
        const char* named;
    } cases[] = {
        {{.dolp = -0.1}, "dolp is -0.1"}, {{.dolp = 1.1}, "0 to 1"},
        {{.dolp = nan}, "dolp"},          {{.docp = -1.5}, "docp is -1.5"},
        {{.docp = nan}, "docp"},          {{.dolp = 0.8, .docp = 0.7}, "sum of their squares"},
        {{.aolp = HUGE_VAL}, "aolp"},     {{.axis = glm::dvec3(0.0)}, "axis"},
        {{.axis = {nan, 0, 0}}, "axis"},
    };
    for (const auto& c : cases) check_error(ErrorCode::invalid_argument, CALL(check(c.state)), c.named);
    CHECK_NOTHROW(check(PolarizationState{.dolp = 0.6, .aolp = 100, .docp = -0.8}));
}
