// SPDX-License-Identifier: MIT
// Tests of light in closed form: constant and Rayleigh sky.
#include "harmonics/evaluate.hpp"
#include "harmonics/rotation.hpp"
#include "light/images.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("constant light has the one coefficient sqrt(4 pi) L") {
    const auto light = constant_environment({2, 0.5});
    CHECK(light->channels() == 2);
    CHECK_FALSE(light->polarized());
    CHECK_FALSE(light->circular());
    const PshVector f = light->project(3);
    for (int c = 0; c < 2; ++c)
        for (std::size_t i = 0; i < f.channel(c).size(); ++i)
            CHECK(f.channel(c)[i] == doctest::Approx(i == 0 ? (c == 0 ? 2 : 0.5) * std::sqrt(4 * pi) : 0));
    CHECK(light->radiance(1, {0, 0, 1}) == Stokes(0.5, 0, 0, 0));
    const EquirectImage image = light->image();
    CHECK(image.stokes(0, 1, 1) == Stokes(2, 0, 0, 0));
}

TEST_CASE("a Rayleigh sky with the sun at +z has the coefficients of its closed form") {
    const auto light = rayleigh_sky({.sun_direction = {0, 0, 3}, .dop_max = 0.6, .radiance = {2}});
    CHECK(light->polarized());
    CHECK_FALSE(light->circular());
    const PshVector f = light->project(5);
    // 3/4 (1 + cos^2) = P_0 + P_2 / 2, and s1 = -3/4 dop sin^2, because the field lies along phi-hat. There
    // 2Y_20 = sqrt(5 / 4 pi) sqrt(6)/4 sin^2.
    PshVector expected(5, 1);
    expected.at(0, 0, 0, 0) = 2 * std::sqrt(4 * pi);
    expected.at(0, 2, 0, 0) = std::sqrt(4 * pi / 5);
    expected.at(0, 2, 0, 1) = -2 * 0.6 * 3 / std::sqrt(6) * std::sqrt(4 * pi / 5);
    CHECK(largest_difference(f, expected) < 1e-14);
}

TEST_CASE("a Rayleigh sky is what its coefficients say, and rotates with the sun") {
    const glm::dvec3 sun(0.3, 0.8, -0.5);
    const auto light = rayleigh_sky({.sun_direction = sun, .radiance = {1, 0.25, 3}});
    const PshVector f = light->project(6);
    for (const glm::dvec3& w : random_directions(200)) {
        const Stokes s = light->radiance(2, w);
        CHECK(glm::length(s - evaluate(f, 2, -w)) < 1e-13);
        const double cosine = glm::dot(glm::normalize(sun), w);
        CHECK(std::hypot(s[1], s[2]) / s[0] ==
              doctest::Approx(0.8 * (1 - cosine * cosine) / (1 + cosine * cosine)));
    }
    const glm::dmat3 rotation = some_rotation(7);
    const auto rotated_light = rayleigh_sky({.sun_direction = rotation * sun, .radiance = {1, 0.25, 3}});
    CHECK(largest_difference(rotated_light->project(6), rotated(f, rotation)) < 1e-13);
    CHECK(light->project(0).at(2, 0, 0, 0) == doctest::Approx(3 * std::sqrt(4 * pi)));
    CHECK(light->project(1).at(1, 1, 0, 0) == doctest::Approx(0));
}

TEST_CASE("the sky's image, taken as an environment, is the same light up to its resolution") {
    const auto sky = rayleigh_sky({.sun_direction = {1, 0.4, 0.7}, .radiance = {1, 2}});
    const auto sampled = image_environment(sky->image());
    for (const glm::dvec3& w : random_directions(50, 5))
        CHECK(glm::length(sky->radiance(1, w) - sampled->radiance(1, w)) < 1e-3);
}

TEST_CASE("analytic light is smooth and finite at its special directions") {
    const auto sky = rayleigh_sky({.sun_direction = {0, 1e-200, 0}});
    for (const glm::dvec3 w : {glm::dvec3(0, 1, 0), {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {1, 0, 0}}) {
        const Stokes s = sky->radiance(0, w);
        CHECK(s[0] >= 0.75);
        CHECK(std::isfinite(s[1] + s[2]));
        if (w.y != 0) CHECK(std::hypot(s[1], s[2]) == doctest::Approx(0));
    }
}

TEST_CASE("analytic light refuses what is out of range and says what") {
    const auto bad = ErrorCode::invalid_argument;
    check_error(bad, CALL(constant_environment({})), "radiance");
    check_error(bad, CALL(constant_environment({1, -1})), "channel 1");
    check_error(bad, CALL(constant_environment({not_a_number})), "channel 0");
    check_error(bad, CALL(rayleigh_sky({.sun_direction = {0, 0, 0}})), "sun_direction");
    check_error(bad, CALL(rayleigh_sky({.sun_direction = {0, not_a_number, 1}})), "sun_direction");
    check_error(bad, CALL(rayleigh_sky({.sun_direction = {infinity, 0, 0}})), "sun_direction");
    check_error(bad, CALL(rayleigh_sky({.dop_max = 1.01})), "dop_max");
    check_error(bad, CALL(rayleigh_sky({.dop_max = not_a_number})), "dop_max");
    check_error(bad, CALL(rayleigh_sky({.radiance = {1, infinity}})), "channel 1");
    for (const auto& light : {constant_environment({1}), rayleigh_sky({.radiance = {1}})}) {
        check_error(bad, CALL(light->radiance(1, {0, 0, 1})), "channel 1");
        check_error(bad, CALL(light->radiance(-1, {0, 0, 1})), "channel -1");
        check_error(bad, CALL(light->radiance(0, {0, 0, 1.1})), "unit");
        check_error(bad, CALL(light->radiance(0, {not_a_number, 0, 0})), "unit");
        check_error(bad, CALL(light->project(-1)), "order");
        check_error(bad, CALL(light->project(kMaxOrder + 1)), "order");
    }
    CHECK_FALSE(rayleigh_sky({.dop_max = 0})->polarized());
    CHECK_FALSE(rayleigh_sky({.radiance = {0}})->polarized());
}
