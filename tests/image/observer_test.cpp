// SPDX-License-Identifier: MIT
// Tests of observers, pixel by pixel.
#include "image/observer.hpp"

#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

using Rgb = std::array<int, 3>;

/// Returns one row of grey pixels.
StokesImage row_of(const std::vector<Stokes>& pixels) {
    StokesImage image(static_cast<int>(pixels.size()), 1, 1);
    for (int x = 0; x < image.width; ++x)
        for (std::size_t p = 0; p < 4; ++p)
            image.at(0, 0, x)[p] =
                static_cast<float>(pixels[static_cast<std::size_t>(x)][static_cast<int>(p)]);
    return image;
}

Rgb pixel(const Observation& observation, int x, int y = 0) {
    const auto i = static_cast<std::size_t>(3 * (y * observation.width + x));
    return {observation.rgb.at(i), observation.rgb.at(i + 1), observation.rgb.at(i + 2)};
}

/// Returns linearly polarized light of intensity 1. Its field is at `degrees` from image right,
/// counter-clockwise.
Stokes linear(double degrees, double degree_of_polarization = 1) {
    const double angle = degrees * pi / 180;
    return {1, degree_of_polarization * std::cos(2 * angle), degree_of_polarization * std::sin(2 * angle), 0};
}

const std::string& text_of(const Observation& observation, const std::string& keyword) {
    for (const auto& [key, text] : observation.text)
        if (key == keyword) return text;
    FAIL("no text ", keyword);
    return observation.text.front().second;
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("tone mapping is exposure, clip, and the sRGB curve") {
    const StokesImage image = row_of({{0, 0, 0, 0},
                                      {0.5, 0, 0, 0},
                                      {1, 0, 0, 0},
                                      {7, 0, 0, 0},
                                      {-3, 0, 0, 0},
                                      {0.001, 0, 0, 0},
                                      {not_a_number, 0, 0, 0}});
    const Observation observation = tone_mapped(image);
    CHECK(observation.srgb);
    // Published values of the sRGB curve: 0.5 maps to 188, and 0.001 lies on the straight part: 12.92 * 0.001
    // * 255 = 3.3.
    const int expected[] = {0, 188, 255, 255, 0, 3, 0};
    for (int x = 0; x < 7; ++x) CHECK(pixel(observation, x) == Rgb{expected[x], expected[x], expected[x]});
    CHECK(pixel(tone_mapped(image, -1), 2) == Rgb{188, 188, 188});
    CHECK(pixel(tone_mapped(image, 1), 1) == Rgb{255, 255, 255});
    CHECK(text_of(tone_mapped(image, 1), "Nicol:Scale").find("0.5 in s0") != std::string::npos);

    StokesImage colour(2, 1, 3);
    colour.at(0, 0, 1)[0] = 1;
    colour.at(1, 0, 1)[0] = 0.5f;
    CHECK(pixel(tone_mapped(colour), 1) == Rgb{255, 188, 0});
}

TEST_CASE("signed components: red negative, green positive, linear, with their scale") {
    const StokesImage image = row_of({{1, 0.5, 0, 0}, {1, -0.25, 0, 0}, {1, 0, 0, 0}, {1, -0.125, 1, 0}});
    const Observation observation = signed_component(image, 1);
    CHECK_FALSE(observation.srgb);
    CHECK(pixel(observation, 0) == Rgb{0, 255, 0});
    CHECK(pixel(observation, 1) == Rgb{128, 0, 0});
    CHECK(pixel(observation, 2) == Rgb{0, 0, 0});
    CHECK(pixel(observation, 3) == Rgb{64, 0, 0});
    CHECK(text_of(observation, "Nicol:Scale").find("|s1| = 0.5 (largest") != std::string::npos);
    CHECK(text_of(observation, "Nicol:Observer").find("s1, red negative, green positive") !=
          std::string::npos);
    const Observation given = signed_component(image, 1, 0.25);
    CHECK(pixel(given, 0) == Rgb{0, 255, 0});
    CHECK(pixel(given, 3) == Rgb{128, 0, 0});
    CHECK(text_of(given, "Nicol:Scale").find("0.25 (given)") != std::string::npos);
    CHECK(pixel(signed_component(image, 3), 0) == Rgb{0, 0, 0});
    CHECK(pixel(signed_component(image, 2), 3) == Rgb{0, 255, 0});
}

TEST_CASE("DoLP is 0 to 1 whatever the light") {
    const StokesImage image = row_of({{2, 1, 0, 0},
                                      {1, 0.3, -0.4, 0.5},
                                      {1, 2, 0, 0},
                                      {0, 0, 0, 0},
                                      {0, 1, 1, 0},
                                      {-1, 0.5, 0, 0},
                                      {1e-45, 1e30, 1e30, 0},
                                      {1, not_a_number, 0, 0},
                                      {infinity, 1, 1, 0}});
    const float expected[] = {0.5f, 0.5f, 1, 0, 0, 0, 1, 0, 0};
    const Plane plane = dolp(image);
    for (std::size_t x = 0; x < 9; ++x) CHECK(plane.values[x] == doctest::Approx(expected[x]));
    const Observation observation = dolp_image(image);
    CHECK(observation.srgb);
    for (int x = 0; x < 9; ++x) {
        const int grey =
            expected[x] == 0.5f ? 188 : static_cast<int>(255 * expected[x]);  // sRGB of a half is 188
        CHECK(pixel(observation, x) == Rgb{grey, grey, grey});
    }
}

TEST_CASE("AoLP is counter-clockwise from image right, in (-pi/2, pi/2]") {
    std::vector<Stokes> light;
    const double degrees[] = {0, 30, 45, 89, 90, -89, -45, -10};
    for (const double d : degrees) light.push_back(linear(d, 0.3));
    light.push_back({1, -0.5, -0.0, 0});
    light.push_back({1, 0, 0, 0});
    light.push_back({-1, 0, 1, 0});
    const Plane plane = aolp(row_of(light));
    for (std::size_t i = 0; i < 8; ++i) CHECK(plane.values[i] == doctest::Approx(degrees[i] * pi / 180));
    CHECK(plane.values[8] == doctest::Approx(pi / 2));
    CHECK(plane.values[9] == 0);
    CHECK(plane.values[10] == 0);
}

TEST_CASE(
    "the AoLP wheel: 0 red, +45 yellow-green, 90 cyan, -45 violet; DoLP is saturation, or value with the "
    "sRGB curve") {
    const StokesImage image = row_of({linear(0),
                                      linear(45),
                                      linear(90),
                                      linear(-45),
                                      linear(0, 0.5),
                                      {1, 0, 0, 0},
                                      linear(60),
                                      linear(-60),
                                      {0, 0, 0, 0},
                                      {-1, 1, 1, 0},
                                      linear(20, 1e-9)});
    const Observation light = aolp_image(image);
    const Observation dark = aolp_image(image, AolpStyle::dark);
    const Observation full = aolp_image(image, AolpStyle::full);
    for (const Observation* observation : {&light, &dark, &full}) {
        CHECK_FALSE(observation->srgb);
        CHECK(pixel(*observation, 0) == Rgb{255, 0, 0});
        CHECK(pixel(*observation, 1) == Rgb{128, 255, 0});
        CHECK(pixel(*observation, 2) == Rgb{0, 255, 255});
        CHECK(pixel(*observation, 3) == Rgb{128, 0, 255});
        CHECK(pixel(*observation, 6) == Rgb{0, 255, 0});
        CHECK(pixel(*observation, 7) == Rgb{0, 0, 255});
    }
    CHECK(pixel(light, 4) == Rgb{255, 128, 128});
    CHECK(pixel(dark, 4) == Rgb{188, 0, 0});
    CHECK(pixel(full, 4) == Rgb{255, 0, 0});
    for (const int x : {5, 8, 9, 10}) {
        CHECK(pixel(light, x) == Rgb{255, 255, 255});
        CHECK(pixel(dark, x) == Rgb{0, 0, 0});
        CHECK(pixel(full, x) == Rgb{0, 0, 0});
    }
}

TEST_CASE("a polarizer lets through what stands along it") {
    const StokesImage image = row_of({linear(30), linear(120), {1, 0, 0, 0.7}, linear(30, 0.5), linear(-15)});
    const StokesImage behind = through_polarizer(image, 30 * pi / 180);
    const double passed[] = {1, 0, 0.5, 0.75, 0.5};
    for (int x = 0; x < 5; ++x) {
        const Stokes s = behind.stokes(0, 0, x);
        CHECK(double(behind_polarizer(image, 30 * pi / 180).values[static_cast<std::size_t>(x)]) ==
              doctest::Approx(passed[x]));
        CHECK(s[0] == doctest::Approx(passed[x]));
        CHECK(s[1] == doctest::Approx(passed[x] * std::cos(pi / 3)));
        CHECK(s[2] == doctest::Approx(passed[x] * std::sin(pi / 3)));
        CHECK(s[3] == 0);
    }
    // Light from a polarizer passes an equal polarizer unchanged, and no light passes a crossed one.
    const StokesImage again = through_polarizer(behind, 30 * pi / 180);
    const StokesImage crossed = through_polarizer(behind, 120 * pi / 180);
    for (int x = 0; x < 5; ++x) {
        CHECK(again.stokes(0, 0, x)[0] == doctest::Approx(passed[x]));
        CHECK(crossed.stokes(0, 0, x)[0] == doctest::Approx(0));
    }
}

TEST_CASE("several channels: one of them, or the mean of their Stokes vectors") {
    StokesImage image(1, 1, 3);
    const Stokes light[] = {linear(0), linear(90, 0.5), {4, 0, 1, 0}};
    for (int c = 0; c < 3; ++c)
        for (std::size_t p = 0; p < 4; ++p)
            image.at(c, 0, 0)[p] = static_cast<float>(light[c][static_cast<int>(p)]);
    CHECK(dolp(image, 0).values[0] == doctest::Approx(1));
    CHECK(dolp(image, 2).values[0] == doctest::Approx(0.25));
    CHECK(dolp(image).values[0] == doctest::Approx(std::hypot(0.5, 1) / 6));
    CHECK(aolp(image, 1).values[0] == doctest::Approx(pi / 2));
    CHECK(aolp(image).values[0] == doctest::Approx(std::atan2(1, 0.5) / 2));
    CHECK(text_of(aolp_image(image), "Nicol:Observer").find("mean of all channels") != std::string::npos);
    CHECK(text_of(dolp_image(image, 1), "Nicol:Observer").find("channel 1") != std::string::npos);
}

TEST_CASE("arguments out of range are refused by name") {
    const auto bad = ErrorCode::invalid_argument;
    const StokesImage image(2, 2, 3);
    check_error(bad, CALL(tone_mapped(StokesImage())), "tone_mapped");
    check_error(bad, CALL(tone_mapped(StokesImage(2, 2, 2))), "2 channels");
    check_error(bad, CALL(tone_mapped(image, not_a_number)), "exposure");
    check_error(bad, CALL(tone_mapped(image, infinity)), "exposure");
    check_error(bad, CALL(signed_component(image, 4)), "component 4");
    check_error(bad, CALL(signed_component(image, -1)), "component -1");
    check_error(bad, CALL(signed_component(image, 1, -2)), "scale");
    check_error(bad, CALL(signed_component(image, 1, not_a_number)), "scale");
    check_error(bad, CALL(signed_component(image, 1, 0, 3)), "channel 3");
    check_error(bad, CALL(dolp(image, -2)), "channel -2");
    check_error(bad, CALL(dolp_image(image, 3)), "channel 3");
    check_error(bad, CALL(aolp(image, 3)), "channel 3");
    check_error(bad, CALL(aolp_image(image, static_cast<AolpStyle>(9))), "style");
    check_error(bad, CALL(through_polarizer(image, infinity)), "angle");
}
