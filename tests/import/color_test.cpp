// SPDX-License-Identifier: MIT
#include "import/scene_color.hpp"
#include "test.hpp"

using doctest::Approx;
using namespace nicol;

namespace {

ColorDescription table(std::vector<ColorDescription::Sample> samples) {
    ColorDescription color(0.0);
    color.spectrum = std::move(samples);
    return color;
}

const SceneChannels rgb{};
const SceneChannels spectral{.count = 4, .wavelengths = {450, 500, 550, 620}};
const SceneChannels unnamed{.count = 5, .wavelengths = {}};

double luminance(const std::vector<double>& c) {
    return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
}

}  // namespace

TEST_CASE("grey is one value if the film has one channel, and three if it has colours") {
    const SceneChannels one{.wavelengths = {}, .one_for_grey = true};
    const ColorDescription grey(0.4), red(glm::dvec3(0.4, 0.1, 0.1));
    for (const auto convert : {&reflectance, &radiance, &refractive_index}) {
        CHECK(convert(grey, one) == std::vector<double>{0.4});
        CHECK(convert(grey, rgb) == std::vector<double>{0.4, 0.4, 0.4});
        CHECK(convert(red, one) == convert(red, rgb));
    }
}

TEST_CASE("three values are red, green and blue") {
    const ColorDescription color(glm::dvec3(0.1, 0.2, 0.3));
    CHECK(reflectance(color, rgb) == std::vector<double>{0.1, 0.2, 0.3});
    CHECK(radiance(color, rgb) == std::vector<double>{0.1, 0.2, 0.3});
    CHECK(refractive_index(color, rgb) == std::vector<double>{0.1, 0.2, 0.3});
    for (const SceneChannels& other : {spectral, unnamed}) {
        for (const auto convert : {&reflectance, &radiance, &refractive_index}) {
            CHECK(convert(ColorDescription(0.7), other) == std::vector<double>{0.7});
            check_error(ErrorCode::unsupported, CALL(convert(color, other)), "red, green and blue");
        }
    }
}

TEST_CASE("a constant reflectance is grey, constant light is white of equal energy") {
    const ColorDescription flat = table({{360, 0.5}, {830, 0.5}});
    for (const double c : reflectance(flat, rgb)) CHECK(c == Approx(0.5));
    // XYZ = (1, 1, 1) in linear BT.709.
    const std::vector<double> light = radiance(flat, rgb);
    CHECK(light[0] / 0.5 == Approx(1.2048).epsilon(2e-3));
    CHECK(light[1] / 0.5 == Approx(0.9484).epsilon(2e-3));
    CHECK(light[2] / 0.5 == Approx(0.9089).epsilon(2e-3));
    CHECK(luminance(light) == Approx(0.5).epsilon(1e-3));
}

TEST_CASE("a table is zero beyond its ends, and the rest is clipped to the gamut") {
    // The radiances of the two halves of the spectrum add up to the whole.
    const std::vector<double> low = radiance(table({{360, 1}, {559.5, 1}}), rgb);
    const std::vector<double> high = radiance(table({{559.5, 1}, {830, 1}}), rgb);
    CHECK(luminance(low) + luminance(high) == Approx(1).epsilon(0.2));
    CHECK(low[2] == Approx(0.93).epsilon(0.1));
    CHECK(low[0] == 0);   // green-blue lies outside the gamut
    CHECK(high[2] == 0);  // so does yellow
    const std::vector<double> line = reflectance(table({{519, 0}, {520, 1}, {521, 0}}), rgb);
    CHECK(line[0] == 0);
    CHECK(line[1] > 0);
    for (const double c : reflectance(table({{580, 1}, {700, 1}}), rgb)) {
        CHECK(c >= 0);
        CHECK(c <= 1);
    }
}

TEST_CASE("an index is red, green and blue as reflectances are, within its range") {
    const ColorDescription slope = table({{400, 0.4}, {600, 0.6}});
    CHECK(refractive_index(slope, rgb) == reflectance(slope, rgb));
    for (const double index : refractive_index(table({{360, 99}, {830, 99}}), rgb))
        CHECK(index == doctest::Approx(99));
    CHECK(refractive_index(table({{600, 200}, {830, 200}}), rgb)[0] == 100);
}

TEST_CASE("light of one value as a spectrum has equal energy, which sRGB shows a little red") {
    ColorDescription even(2.0);
    CHECK(radiance(even, rgb) == std::vector<double>{2, 2, 2});
    even.equal_energy = true;
    const std::vector<double> light = radiance(even, rgb);
    REQUIRE(light.size() == 3);
    CHECK(light[0] == doctest::Approx(2 * 1.2048).epsilon(1e-3));
    CHECK(light[1] == doctest::Approx(2 * 0.9483).epsilon(1e-3));
    CHECK(light[2] == doctest::Approx(2 * 0.9087).epsilon(1e-3));
    // Other quantities of equal energy are grey.
    CHECK(reflectance(ColorDescription(even), rgb) == std::vector<double>{2, 2, 2});
}

TEST_CASE("channels that are wavelengths read a table there") {
    const ColorDescription slope = table({{480, 0.48}, {600, 0.6}});
    for (const auto convert : {&reflectance, &radiance}) {
        const std::vector<double> values = convert(slope, spectral);
        REQUIRE(values.size() == 4);
        CHECK(values[0] == 0);
        CHECK(values[1] == Approx(0.5));
        CHECK(values[2] == Approx(0.55));
        CHECK(values[3] == 0);
        CHECK_THROWS_AS(static_cast<void>(convert(slope, unnamed)), Error);
    }
    CHECK(refractive_index(slope, spectral)[0] == Approx(0.48));
    CHECK(refractive_index(slope, spectral)[3] == Approx(0.6));
}
