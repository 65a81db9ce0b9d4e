// SPDX-License-Identifier: MIT
#include "reference/surface_sampler.hpp"

#include "material/conductor.hpp"
#include "sampling.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

glm::dvec3 viewer_at(double degrees) {
    const double theta = degrees * pi / 180;
    return {std::sin(theta) * std::cos(0.7), std::sin(theta) * std::sin(0.7), std::cos(theta)};
}

}  // namespace

TEST_CASE("the density integrates to 1 over the sphere and is that of the samples") {
    const auto plastic = [](double alpha) {
        return pplastic({.alpha = alpha, .distribution = Distribution::ggx});
    };
    const struct {
        const char* name;
        MaterialPtr material;
    } rows[] = {{"smooth", plastic(0.1)},
                {"glossy", plastic(0.3)},
                {"rough", plastic(0.8)},
                {"brushed metal", rough_conductor({.alpha = 0.5, .alpha_v = 0.1})}};
    for (const auto& [name, material] : rows) {
        const SurfaceSampler sampler(*material);
        for (const double degrees : {0.0, 40.0, 75.0, 83.0}) {
            CAPTURES(name, degrees);
            const glm::dvec3 viewer = viewer_at(degrees);
            const std::vector<double> expected =
                integrals([&](const glm::dvec3& d) { return sampler.pdf(viewer, d); });
            CHECK(sum(expected) == doctest::Approx(1).epsilon(2e-3));
            const double excess = chi_square_excess(
                [&](const glm::dvec2& p) { return sampler.sample(viewer, p); }, expected, 200000, 2);
            CHECK(excess < 5);
        }
    }
}

TEST_CASE("a diffuse surface is sampled by the cosine") {
    const SurfaceSampler sampler(*diffuse({0.5}));
    const glm::dvec3 viewer = viewer_at(60);
    for (const double degrees : {0.0, 30.0, 89.0}) {
        const glm::dvec3 d = viewer_at(degrees);
        CHECK(sampler.pdf(viewer, d) == doctest::Approx(d.z / pi).epsilon(1e-14));
        CHECK(sampler.pdf(viewer, -d) == 0);
    }
}

TEST_CASE("samples are unit directions, and every direction above the horizon has a density") {
    for (const double alpha : {0.001, 0.05, 1.0}) {
        const MaterialPtr material = pplastic({.alpha = alpha});
        const SurfaceSampler sampler(*material);
        for (const double degrees : {0.0, 50.0, 89.9}) {
            const glm::dvec3 viewer = viewer_at(degrees);
            for (int i = 0; i <= 40; ++i) {
                for (int j = 0; j <= 40; ++j) {
                    const double last = std::nextafter(1.0, 0.0);
                    const glm::dvec3 d =
                        sampler.sample(viewer, {std::min(i / 40.0, last), std::min(j / 40.0, last)});
                    REQUIRE(glm::length(d) == doctest::Approx(1).epsilon(1e-9));
                    REQUIRE(std::isfinite(sampler.pdf(viewer, d)));
                    if (d.z > 0) REQUIRE(sampler.pdf(viewer, d) > 0);
                }
            }
            REQUIRE(sampler.pdf(viewer, viewer_at(89.99)) > 0);
        }
    }
}

TEST_CASE("narrow lobes are sampled where they are") {
    // Nearly all of a lobe of width 0.02 lies within 0.2 of the mirror direction, and half of the samples go
    // there.
    const MaterialPtr material = pplastic({.alpha = 0.02});
    const SurfaceSampler sampler(*material);
    const glm::dvec3 viewer = viewer_at(30);
    const glm::dvec3 mirrored(-viewer.x, -viewer.y, viewer.z);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform;
    int inside = 0;
    for (int i = 0; i < 10000; ++i) {
        const double x = uniform(random);
        inside += glm::distance(sampler.sample(viewer, {x, uniform(random)}), mirrored) < 0.2 ? 1 : 0;
    }
    CHECK(inside > 4800);
    CHECK(inside < 5500);
}
