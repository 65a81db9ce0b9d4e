// SPDX-License-Identifier: MIT
// Tests of the sun of a sky.
#include "light/sun.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

RayleighSky sky_with(double elevation, double turbidity) {
    const double a = elevation * pi / 180;
    return {.sun_direction = {3 * std::cos(a), 3 * std::sin(a), 0}, .turbidity = turbidity};
}

double luminance(const std::vector<double>& rgb) {
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

/// Returns the illuminance of a level surface by the sun over that by its sky, whose mean luminance is 1.
double sun_over_sky(double elevation, double turbidity) {
    const RayleighSky sky = sky_with(elevation, turbidity);
    const auto light = rayleigh_sky(sky);
    constexpr int rings = 200;
    double from_sky = 0;
    for (int j = 0; j < rings; ++j)
        for (int i = 0; i < rings; ++i) {
            const double y = (j + 0.5) / rings, r = std::sqrt(1 - y * y), a = 2 * pi * (i + 0.5) / rings;
            const glm::dvec3 w(r * std::cos(a), y, r * std::sin(a));
            const std::vector<double> rgb{light->radiance(0, w)[0], light->radiance(1, w)[0],
                                          light->radiance(2, w)[0]};
            from_sky += y * luminance(rgb) * 2 * pi / (rings * rings);
        }
    return std::sin(elevation * pi / 180) * luminance(sun_of(sky).value) / from_sky;
}

}  // namespace

TEST_CASE("the sun lights a level surface some times as much as its sky") {
    // Numbers of the same formulas, computed apart: klx of the sun over klx of the sky.
    CHECK(sun_over_sky(60, 2) == doctest::Approx(85.13 / 24.42).epsilon(0.02));
    CHECK(sun_over_sky(45, 3) == doctest::Approx(57.01 / 28.91).epsilon(0.02));
    CHECK(sun_over_sky(60, 6) == doctest::Approx(54.02 / 56.08).epsilon(0.02));
    CHECK(sun_over_sky(10, 3) == doctest::Approx(3.633 / 14.24).epsilon(0.02));
}

TEST_CASE("the sun stands where the sky has it, reddens towards the horizon and follows the radiance") {
    for (const double elevation : {0.5, 5.0, 30.0, 90.0}) {
        const LocalLight sun = sun_of(sky_with(elevation, 3));
        const double a = elevation * pi / 180;
        CHECK(glm::length(glm::dvec3(sun.to_world[2]) + glm::dvec3(std::cos(a), std::sin(a), 0)) < 1e-12);
        CHECK(glm::determinant(glm::dmat3(sun.to_world)) == doctest::Approx(1));
        const LocalLight lower = sun_of(sky_with(0.8 * elevation, 3));
        CHECK(lower.value[2] / lower.value[0] < sun.value[2] / sun.value[0]);
        // Higher up the sun gains less than the sky, whose mean is 1.
        for (std::size_t c = 0; c < 3 && elevation <= 30; ++c) CHECK(lower.value[c] < sun.value[c]);

        RayleighSky grey = sky_with(elevation, 3);
        grey.radiance = {0.5};
        const std::vector<double> value = sun_of(grey).value;
        REQUIRE(value.size() == 1);
        CHECK(value[0] == doctest::Approx(0.5 * luminance(sun.value)).epsilon(1e-6));
    }
}

TEST_CASE("a sun below the horizon is dark, and a sky without haze has the sun of the clearest one") {
    CHECK(sun_of({.sun_direction = {1, -0.1, 0}}).value == std::vector<double>{0, 0, 0});
    CHECK(sun_of(sky_with(40, 0)).value == sun_of(sky_with(40, 1.7)).value);
    CHECK_THROWS_AS(static_cast<void>(sun_of({.sun_direction = {1, -0.1, 0}, .turbidity = 3})), Error);
    CHECK_THROWS_AS(static_cast<void>(sun_of({.sun_direction = {0, 0, 0}})), Error);
}
