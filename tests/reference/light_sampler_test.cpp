// SPDX-License-Identifier: MIT
#include "directions.hpp"
#include "reference/light_samplers.hpp"
#include "sampling.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

// Returns noise with black pixels, an area light, and a colour in only one channel.
EquirectImage image() {
    EquirectImage image(24, 13, 2);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const bool black = x > 4 && x < 9 && y > 3 && y < 8;
            for (int c = 0; c < 2; ++c) image.at(c, y, x)[0] = black ? 0 : uniform(random);
        }
    }
    image.at(1, 6, 15)[0] = 30;
    image.at(0, 10, 3)[0] = 0;
    return image;
}

double luminance(const Environment& light, const glm::dvec3& d) {
    double sum = 0;
    for (int c = 0; c < light.channels(); ++c) sum += light.radiance(c, d)[0];
    return sum / light.channels();
}

}  // namespace

TEST_CASE("the density integrates to 1 and is that of the samples") {
    for (const EnvironmentPtr& light : {image_environment(image()), constant_environment({0.2, 3}),
                                        rayleigh_sky({.sun_direction = {1, 1, 0}})}) {
        const LightSampler sampler(*light);
        REQUIRE(!sampler.dark());
        const std::vector<double> expected = integrals([&](const glm::dvec3& d) { return sampler.pdf(d); });
        CHECK(sum(expected) == doctest::Approx(1).epsilon(1e-3));
        const double excess = chi_square_excess(
            [&](const glm::dvec2& p) { return sampler.sample(p).towards_light; }, expected, 400000, 1);
        CHECK(excess < 5);
    }
}

TEST_CASE("a sample is a unit direction with the density of that direction") {
    const EnvironmentPtr light = image_environment(image());
    const LightSampler sampler(*light);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform;
    for (int i = 0; i < 20000; ++i) {
        const double x = i < 100 ? 0 : i < 200 ? std::nextafter(1.0, 0.0) : uniform(random);
        const double y = i % 100 == 0 ? 0 : i % 100 == 1 ? std::nextafter(1.0, 0.0) : uniform(random);
        const LightSample s = sampler.sample({x, y});
        REQUIRE(glm::length(s.towards_light) == doctest::Approx(1).epsilon(1e-12));
        REQUIRE(s.pdf >= 0);
        // The poles are skipped, because the image has no unique value there.
        if (std::abs(s.towards_light.y) > 1 - 1e-9) continue;
        REQUIRE(std::abs(s.pdf - sampler.pdf(s.towards_light)) < 1e-6 * (s.pdf + 0.1));
    }
}

TEST_CASE("samples weighted by 1 / density integrate the light, with little noise") {
    const EnvironmentPtr light = image_environment(image());
    const LightSampler sampler(*light);
    const double exact = sum(integrals([&](const glm::dvec3& d) { return luminance(*light, d); }));
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> uniform;
    constexpr int count = 100000;
    double mean = 0, square = 0;
    for (int i = 0; i < count; ++i) {
        const double x = uniform(random);
        const LightSample s = sampler.sample({x, uniform(random)});
        const double value = luminance(*light, s.towards_light) / s.pdf;
        mean += value / count;
        square += value * value / count;
    }
    CHECK(mean == doctest::Approx(exact).epsilon(2e-3));
    // The density is nearly proportional. Without the area light's share the ratio would vary by several
    // times the mean.
    CHECK(std::sqrt(square - mean * mean) < 0.15 * mean);
}

TEST_CASE("the density is zero only where there is no light") {
    const EnvironmentPtr light = image_environment(image());
    const LightSampler sampler(*light);
    int dark = 0;
    for (const glm::dvec3& d : random_directions(20000, 7)) {
        if (luminance(*light, d) > 0) {
            REQUIRE(sampler.pdf(d) > 0);
        } else {
            ++dark;
            REQUIRE(sampler.pdf(d) == 0);
        }
    }
    CHECK(dark > 100);
}

TEST_CASE("darkness has no samples") {
    const EnvironmentPtr light = constant_environment({0, 0});
    const LightSampler sampler(*light);
    CHECK(sampler.dark());
    CHECK(sampler.pdf({0, 0, 1}) == 0);
}
