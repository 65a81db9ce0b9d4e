// SPDX-License-Identifier: MIT
// Tests of directions sampled from lobes: their mean against the integral of the pBRDF, and the smooth limit.
#include "shading/lobe_sample.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <vector>

#include "material/conductor.hpp"
#include "polarization/fresnel.hpp"
#include "polarization/stokes.hpp"
#include "test.hpp"

using namespace nicol;
using std::numbers::pi;

namespace {

constexpr std::complex<double> kIndex(0.3, -2.5);

/// Returns polarized light that varies smoothly with the direction it comes from, in the theta-phi frame.
Stokes light_from(const glm::dvec3& towards_light) {
    const double x = towards_light.x, y = towards_light.y, z = towards_light.z;
    const Stokes field(1 + 0.4 * x + 0.3 * y * z, 0.4 + 0.2 * z, -0.3 + 0.2 * x, 0.3 * y + 0.2);
    const Frame fixed = frame_with_x(-towards_light, glm::cross(glm::dvec3(0.2, 0.9, 0.4), towards_light));
    return rotated(field, angle_between(fixed, theta_phi_frame(-towards_light)));
}

/// Returns the integral over all directions of what a material's followed terms reflect in a channel.
Stokes integrated(const Material& material, int channel, const glm::dvec3& viewer) {
    constexpr int rows = 700, columns = 1400;
    Stokes sum(0.0);
    for (int i = 0; i < rows; ++i) {
        const double z = (i + 0.5) / rows, rho = std::sqrt(1 - z * z);
        for (int j = 0; j < columns; ++j) {
            const double phi = 2 * pi * (j + 0.5) / columns;
            const glm::dvec3 light(rho * std::cos(phi), rho * std::sin(phi), z);
            for (int t = 0; t < material.terms(); ++t)
                if (is_followed(material, t, SampledTerms::none))
                    sum += z * material.weight(t, channel) *
                           (material.evaluate(t, light, viewer) * light_from(light));
        }
    }
    return sum * (2 * pi / rows / columns);
}

}  // namespace

TEST_CASE("the mean over sampled directions is the integral of what narrow lobes reflect") {
    const MaterialPtr brushed = rough_conductor({.eta = {kIndex},
                                                 .specular_reflectance = {{0.9, 0.6, 0.3}},
                                                 .alpha = 0.12,
                                                 .alpha_v = 0.3,
                                                 .distribution = Distribution::beckmann});
    const MaterialPtr round = rough_conductor(
        {.eta = {kIndex, {1.2, -4.0}, {0.5, -1.5}}, .alpha = 0.2, .distribution = Distribution::ggx});
    const std::vector<FollowedLayer> layers{followed_layers(*brushed, SampledTerms::none).front(),
                                            followed_layers(*round, SampledTerms::none).front()};
    const std::array weights{glm::vec3(0.3, 0.5, 0.7), glm::vec3(0.6, 0.2, 0.4)};
    for (const glm::dvec3& viewer :
         {glm::normalize(glm::dvec3(0.3, -0.2, 1)), glm::normalize(glm::dvec3(0.6, 1.1, 0.7))}) {
        constexpr int size = 300;
        std::array<Stokes, 3> sums{};
        std::array<Mueller, 3> muellers;
        for (int i = 0; i < size; ++i)
            for (int j = 0; j < size; ++j) {
                // Rows of facets choose lobes in turn, evenly.
                const LobeChoice choice{.lobe = std::fmod((i * size + j) * 0.6180339887498949, 1.0),
                                        .facet = {(i + 0.5) / size, (j + 0.5) / size}};
                const glm::dvec3 light = sample_lobes(layers, weights, viewer, choice, muellers);
                if (light.z > 0)
                    for (std::size_t c = 0; c < 3; ++c) sums[c] += muellers[c] * light_from(light);
            }
        for (std::size_t c = 0; c < 3; ++c) {
            const int channel = static_cast<int>(c);
            const Stokes expected = double{weights[0][channel]} * integrated(*brushed, channel, viewer) +
                                    double{weights[1][channel]} * integrated(*round, channel, viewer);
            for (int p = 0; p < 4; ++p)
                CHECK(sums[c][p] / (size * size) == doctest::Approx(expected[p]).epsilon(2e-3).scale(1));
        }
    }
}

TEST_CASE("a hardly rough metal reflects light from the mirrored direction as Fresnel says") {
    const MaterialPtr metal = rough_conductor({.eta = {kIndex}, .alpha = 0.001});
    const std::vector<FollowedLayer> layers = followed_layers(*metal, SampledTerms::none);
    const std::array weights{glm::vec3(1)};
    const glm::dvec3 viewer = glm::normalize(glm::dvec3(0.8, 0, 0.6));
    Mueller mueller;
    const glm::dvec3 light =
        sample_lobes(layers, weights, viewer, {.lobe = 0.5, .facet = {0.4, 0.7}}, std::span(&mueller, 1));
    CHECK(glm::length(light - glm::dvec3(-viewer.x, -viewer.y, viewer.z)) < 0.01);
    // Facets' distribution and its stand-in differ, so that elements are compared with the first one.
    const Mueller expected = fresnel_reflection(0.6, kIndex);
    CHECK(mueller(1, 0) / mueller(0, 0) == doctest::Approx(-expected(1, 0) / expected(0, 0)).epsilon(0.02));
    CHECK(mueller(2, 2) / mueller(0, 0) == doctest::Approx(expected(2, 2) / expected(0, 0)).epsilon(0.02));
    CHECK(std::abs(mueller(3, 2) / mueller(0, 0)) ==
          doctest::Approx(std::abs(expected(3, 2) / expected(0, 0))).epsilon(0.02));
}

TEST_CASE("strong lobes are followed if they are narrow, and coats of plastics are not") {
    CHECK(follows_lobes(*rough_conductor({.eta = {kIndex}, .alpha = 0.1})));
    CHECK(follows_lobes(*rough_conductor({.eta = {kIndex}, .alpha = 0.1, .alpha_v = 0.7})));
    CHECK_FALSE(follows_lobes(*rough_conductor({.eta = {kIndex}, .alpha = 0.6})));
    CHECK_FALSE(follows_lobes(*conductor({kIndex})));
    CHECK_FALSE(follows_lobes(*pplastic({.alpha = 0.1})));
    CHECK_FALSE(follows_lobes(*diffuse({0.5})));
}

TEST_CASE("the mean over directions that lobes send light in is what they reflect in all directions") {
    constexpr int size = 400;
    const Stokes light(1, 0.5, -0.4, 0.3);
    const struct {
        double alpha, alpha_v;
        Distribution distribution;
        glm::dvec3 towards_light;
        std::optional<AimedCone> aim;
    } rows[] = {{0.1, 0, Distribution::ggx, {0.3, -0.2, 1}, {}},
                {0.2, 0, Distribution::beckmann, {-0.9, 0.4, 0.6}, {}},
                {0.08, 0.24, Distribution::beckmann, {0.6, 1.1, 0.7}, {}},
                {0.08, 0.24, Distribution::beckmann, {0.6, 1.1, 0.7}, AimedCone{{-0.6, 0, 0.8}, 0.9}},
                {0.2, 0, Distribution::ggx, {-0.9, 0.4, 0.6}, AimedCone{{1, 0, 0}, 0.8}}};
    for (const auto& row : rows) {
        CAPTURE(row.alpha);
        const MaterialPtr metal = rough_conductor(
            {.eta = {kIndex}, .alpha = row.alpha, .alpha_v = row.alpha_v, .distribution = row.distribution});
        const glm::dvec3 from = glm::normalize(row.towards_light);
        const std::vector<FollowedLayer> layers =
            layers_with(*metal, [](const Material&, int) { return true; });
        const std::array weights{glm::vec3(1)};
        std::array<Mueller, 1> sent;
        double sum = 0;
        for (const double lobe : {0.25, 0.75})  // the first in the cone, if there is one
            for (int i = 0; i < size; ++i)
                for (int j = 0; j < size; ++j) {
                    const LobeChoice choice{.lobe = lobe, .facet = {(i + 0.5) / size, (j + 0.5) / size}};
                    static_cast<void>(scatter_by_lobes(layers, weights, from, choice, row.aim, sent));
                    sum += (sent[0] * light).x / 2;
                }
        double expected = 0;
        for (int i = 0; i < size; ++i)
            for (int j = 0; j < 2 * size; ++j) {
                const double z = (i + 0.5) / size, rho = std::sqrt(1 - z * z), phi = pi * (j + 0.5) / size;
                const glm::dvec3 to(rho * std::cos(phi), rho * std::sin(phi), z);
                for (int t = 0; t < metal->terms(); ++t)
                    expected += z * metal->weight(t, 0) * (metal->evaluate(t, from, to) * light).x;
            }
        CHECK(sum / (size * size) == doctest::Approx(expected * pi / (size * size)).epsilon(0.005));
    }
}
