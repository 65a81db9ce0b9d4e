// SPDX-License-Identifier: MIT
// Tests of the hazy sky: colour, radiance, polarization and ground.
#include "light/turbid_sky.hpp"
#include "light/images.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

RayleighSky hazy(const glm::dvec3& sun, double turbidity = 3) {
    RayleighSky sky;
    sky.sun_direction = sun;
    sky.turbidity = turbidity;
    return sky;
}

double luminance(const Environment& light, const glm::dvec3& towards_light) {
    return 0.2126729 * light.radiance(0, towards_light)[0] + 0.7151522 * light.radiance(1, towards_light)[0] +
           0.0721750 * light.radiance(2, towards_light)[0];
}

/// Returns the mean of `weight` times s0 over the upper hemisphere, by rings of equal height.
double upper_mean(const Environment& light, int channel, double (*weight)(double height)) {
    constexpr int rings = 300;
    double sum = 0;
    for (int j = 0; j < rings; ++j) {
        const double y = (j + 0.5) / rings;
        const double r = std::sqrt(1 - y * y);
        for (int i = 0; i < rings; ++i) {
            const double a = 2 * pi * (i + 0.5) / rings;
            sum += weight(y) * light.radiance(channel, {r * std::cos(a), y, r * std::sin(a)})[0];
        }
    }
    return sum / (rings * rings);
}

}  // namespace

TEST_CASE("Perez's formula gives its zenith value at the zenith") {
    // Zenith luminance and chromaticity of Preetham's appendix, computed by hand for T = 2 and the sun at 45
    // degrees: chi = (4/9 - 1/60) pi/2 = 0.671940, tan = 0.794892, Y = 3.1196 tan - 0.431 + 2.4192.
    const double z = pi / 4;
    const PerezSky sky(2, z);
    const auto zenith = sky.at(1, z);
    CHECK(zenith[0] ==
          doctest::Approx(3.1196 * std::tan((4.0 / 9 - 2.0 / 120) * pi / 2) + 1.9882).epsilon(1e-12));
    CHECK(zenith[1] == doctest::Approx(0.2492).epsilon(0.02));
    CHECK(zenith[2] == doctest::Approx(0.2528).epsilon(0.02));
    const auto white = linear_srgb({1, 0.3127, 0.3290});
    for (const double v : white) CHECK(v == doctest::Approx(1).epsilon(1e-3));
}

TEST_CASE(
    "a clear sky is blue at the zenith, whiter at the horizon and brightest at the sun among its like") {
    const glm::dvec3 sun = glm::normalize(glm::dvec3(1, 1, 0));
    const auto light = rayleigh_sky(hazy(sun, 2));
    const glm::dvec3 up(0, 1, 0);
    const glm::dvec3 far_horizon = glm::normalize(glm::dvec3(-1, 0.02, 0.1));
    const auto blueness = [&](const glm::dvec3& w) {
        return light->radiance(2, w)[0] / light->radiance(0, w)[0];
    };
    CHECK(blueness(up) > 2);
    CHECK(blueness(far_horizon) < blueness(up));
    // The sun is brighter than directions of equal elevation and than those between it and the zenith.
    for (int i = 1; i < 36; ++i) {
        const double a = 2 * pi * i / 36;
        CHECK(luminance(*light, sun) >
              1.05 * luminance(*light, glm::normalize(glm::dvec3(std::cos(a), 1, std::sin(a)))));
        const double b = pi / 4 * i / 36;
        CHECK(luminance(*light, sun) > luminance(*light, {std::sin(b - pi / 4), std::cos(b - pi / 4), 0}));
    }
    // More haze makes the sky less blue.
    CHECK(rayleigh_sky(hazy(sun, 8))->radiance(2, up)[0] / rayleigh_sky(hazy(sun, 8))->radiance(0, up)[0] <
          blueness(up));
}

TEST_CASE("the mean luminance of the upper half is 1, whatever the sun and the haze") {
    for (const double turbidity : {1.7, 3.0, 10.0}) {
        for (const glm::dvec3& sun : {glm::dvec3(0, 2, 0), glm::dvec3(1, 0.3, -1), glm::dvec3(0, 0, 1)}) {
            RayleighSky sky = hazy(sun, turbidity);
            sky.radiance = {2};
            const auto light = rayleigh_sky(sky);
            CHECK(upper_mean(*light, 0, [](double) { return 1.0; }) == doctest::Approx(2).epsilon(5e-3));
        }
    }
}

TEST_CASE("polarization is Rayleigh's: across the plane of the sun, strongest at 90 degrees") {
    const glm::dvec3 sun = glm::normalize(glm::dvec3(0.3, 0.5, -0.7));
    RayleighSky sky = hazy(sun);
    sky.dop_max = 0.6;
    const auto light = rayleigh_sky(sky);
    CHECK(light->polarized());
    CHECK_FALSE(light->circular());
    for (const glm::dvec3& w : random_directions(500)) {
        if (w.y < 0.02) continue;
        const double cosine = glm::dot(w, sun);
        if (std::abs(cosine) > 0.99) continue;
        const double degree = 0.6 * (1 - cosine * cosine) / (1 + cosine * cosine);
        const Frame frame = frame_with_x(-w, glm::cross(sun, w));
        for (int c = 0; c < 3; ++c) {
            const Stokes s = rotated(light->radiance(c, w), angle_between(theta_phi_frame(-w), frame));
            CHECK(s[1] / s[0] == doctest::Approx(degree).epsilon(0.01));
            CHECK(std::abs(s[2] / s[0]) < 0.01);
        }
    }
}

TEST_CASE("the ground reflects its share of the irradiance of each channel") {
    RayleighSky sky = hazy({0, 1, 1});
    const std::vector<double> albedo = {0.3, 0.6, 0};
    sky.ground_albedo = albedo;
    sky.radiance = {1, 2, 0.5};
    const auto light = rayleigh_sky(sky);
    for (int c = 0; c < 3; ++c) {
        const double irradiance = 2 * pi * upper_mean(*light, c, [](double height) { return height; });
        const Stokes down = light->radiance(c, {0, -1, 0});
        CHECK(down[0] ==
              doctest::Approx(albedo[static_cast<std::size_t>(c)] / pi * irradiance).epsilon(2e-3));
        CHECK(down[1] == 0);
        CHECK(light->radiance(c, glm::normalize(glm::dvec3(1, -0.1, 0)))[0] == doctest::Approx(down[0]));
    }
}

TEST_CASE("skies out of range are refused") {
    const auto bad = ErrorCode::invalid_argument;
    for (const double turbidity :
         {-1.0, 1.0, 1.69, 10.1, std::nan(""), std::numeric_limits<double>::infinity()})
        check_error(bad, CALL(rayleigh_sky(hazy({0, 1, 0}, turbidity))), "turbidity");
    check_error(bad, CALL(rayleigh_sky(hazy({1, -0.01, 0}))), "horizon");
    RayleighSky sky = hazy({0, 1, 0});
    for (const double albedo : {-0.1, 1.1, std::nan("")}) {
        sky.ground_albedo = {0.1, albedo, 0.1};
        check_error(bad, CALL(rayleigh_sky(sky)), "ground_albedo");
    }
    for (const std::vector<double>& albedo : {std::vector<double>{}, {0.1, 0.2}, {0.1, 0.2, 0.3, 0.4}}) {
        sky.ground_albedo = albedo;
        check_error(bad, CALL(rayleigh_sky(sky)), "ground_albedo", std::to_string(albedo.size()), "3");
    }
    sky.ground_albedo = {0};
    sky.radiance = {1, -1};
    check_error(bad, CALL(rayleigh_sky(sky)), "radiance");
    sky.radiance = {1, 2};
    CHECK(rayleigh_sky(sky)->channels() == 2);
}
