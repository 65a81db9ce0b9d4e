// SPDX-License-Identifier: MIT
// Tests of facets with anisotropic roughness.
#include "material/microfacet.hpp"

#include "directions.hpp"
#include "material/conductor.hpp"
#include "material/mixture.hpp"
#include "material/response_table.hpp"
#include "test.hpp"

using namespace nicol;
using doctest::Approx;

namespace {

constexpr Distribution kDistributions[] = {Distribution::beckmann, Distribution::ggx};

/// Integrates a function of unit directions over the upper hemisphere.
template <class Function>
double integral(const Function& of) {
    constexpr int rows = 1500, columns = 200;
    double sum = 0;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            // Squaring concentrates the points near the normal, because the densities are narrow there.
            const double x = (i + 0.5) / rows;
            const double theta = pi / 2 * x * x;
            sum += of(direction(theta, 2 * pi * (j + 0.5) / columns)) * std::sin(theta) * 2 * x;
        }
    return sum * pi / 2 / rows * 2 * pi / columns;
}

MaterialPtr brushed(double alpha_u, double alpha_v, Distribution distribution = Distribution::ggx) {
    return rough_conductor(
        {.eta = metal_index("Au"), .alpha = alpha_u, .alpha_v = alpha_v, .distribution = distribution});
}

/// Walter's formulas of the angle to the normal.
double density(Distribution distribution, double alpha, double cosine) {
    const double cos2 = cosine * cosine;
    const double tan2 = (1 - cos2) / cos2;
    if (distribution == Distribution::beckmann)
        return std::exp(-tan2 / (alpha * alpha)) / (pi * alpha * alpha * cos2 * cos2);
    return alpha * alpha / (pi * cos2 * cos2 * std::pow(alpha * alpha + tan2, 2));
}

double visibility(Distribution distribution, double alpha, double cosine) {
    const double tangent = alpha * std::sqrt(1 - cosine * cosine) / cosine;
    if (distribution == Distribution::ggx) return 2 / (1 + std::sqrt(1 + tangent * tangent));
    const double a = 1 / tangent;
    return a < 1.6 ? (3.535 * a + 2.181 * a * a) / (1 + 2.276 * a + 2.577 * a * a) : 1;
}

glm::dvec3 by_a_quarter(const glm::dvec3& d) {
    return {-d.y, d.x, d.z};
}

}  // namespace

TEST_CASE("anisotropic facets cover the surface, whatever direction it is seen from") {
    for (const Distribution distribution : kDistributions) {
        for (const glm::dvec2 alpha : {glm::dvec2(0.3, 0.1), glm::dvec2(0.15, 0.7)}) {
            CAPTURES(distribution == Distribution::ggx, alpha.x, alpha.y);
            CHECK(integral([&](const glm::dvec3& h) {
                      return facet_density(distribution, alpha, h) * h.z;
                  }) == Approx(1).epsilon(1e-4));
            // Visible facets make up the projected area (Smith), approximately so with Walter's fit.
            for (const double azimuth : {0.0, 0.6, pi / 2}) {
                const glm::dvec3 view = direction(1.1, azimuth);
                const double visible =
                    facet_visibility(distribution, alpha, view) * integral([&](const glm::dvec3& h) {
                        return facet_density(distribution, alpha, h) * std::max(0.0, glm::dot(view, h));
                    });
                CHECK(visible == Approx(view.z).epsilon(distribution == Distribution::ggx ? 1e-3 : 4e-3));
            }
        }
    }
}

TEST_CASE("facets of the same roughness in both directions are the isotropic ones of Walter et al.") {
    std::mt19937 random(4);
    for (const Distribution distribution : kDistributions) {
        for (int i = 0; i < 500; ++i) {
            const double alpha = 0.02 + 0.002 * i;
            const glm::dvec3 light = random_direction_within(random, 1.55);
            const glm::dvec3 viewer = random_direction_within(random, 1.55);
            const glm::dvec3 half = glm::normalize(light + viewer);
            const double expected = density(distribution, alpha, half.z) *
                                    visibility(distribution, alpha, light.z) *
                                    visibility(distribution, alpha, viewer.z) / (4 * light.z * viewer.z);
            const Facets<double> facets{distribution, alpha};
            const double got = facet_reflection(facets, components(light), components(viewer)).scale;
            CHECK(std::abs(got - expected) <= 1e-12 * std::max(expected, 1.0));
            CHECK(facet_density(distribution, alpha, half.z) ==
                  Approx(density(distribution, alpha, half.z)).epsilon(1e-11));
            CHECK(facet_visibility(distribution, alpha, light.z) ==
                  Approx(visibility(distribution, alpha, light.z)).epsilon(1e-12));
        }
        CHECK(facet_density(distribution, glm::dvec2(0.2, 0.4), glm::dvec3(0.6, 0, -0.8)) == 0);
        CHECK(facet_visibility(distribution, glm::dvec2(0.2, 0.4), glm::dvec3(1, 0, 0)) == 0);
    }
}

TEST_CASE("an anisotropic metal is reciprocal, and turns with its axes") {
    std::mt19937 random(5);
    for (const Distribution distribution : kDistributions) {
        const MaterialPtr along_x = brushed(0.4, 0.1, distribution);
        const MaterialPtr along_y = brushed(0.1, 0.4, distribution);
        bool any_difference = false;
        for (int i = 0; i < 300; ++i) {
            const glm::dvec3 light = random_direction_within(random, 1.5);
            const glm::dvec3 viewer = random_direction_within(random, 1.5);
            const Mueller m = along_x->evaluate(1, light, viewer);
            CHECK(along_x->evaluate(1, viewer, light)(0, 0) == Approx(m(0, 0)).epsilon(1e-12));
            // The theta-phi frames rotate with the directions about the normal.
            CHECK(largest_difference(along_y->evaluate(1, by_a_quarter(light), by_a_quarter(viewer)), m) <=
                  1e-11 * m(0, 0));
            const double other = along_y->evaluate(1, light, viewer)(0, 0);
            any_difference = any_difference || std::abs(other - m(0, 0)) > 0.5 * m(0, 0);
        }
        CHECK(any_difference);
    }
}

TEST_CASE("harmonics have the geometric mean of an anisotropic roughness") {
    const MaterialPtr metal = brushed(0.5, 0.2);
    const MaterialPtr mean = brushed(std::sqrt(0.1), 0);
    CHECK(metal->anisotropic());
    CHECK_FALSE(mean->anisotropic());
    CHECK_FALSE(brushed(0.3, 0.3)->anisotropic());
    CHECK(metal->isotropic().content_key() == mean->content_key());
    CHECK(metal->content_key() != mean->content_key());
    CHECK(brushed(0.2, 0.5)->content_key() != metal->content_key());
    CHECK(metal->lobe_width(0) == 0.2);
    CHECK(metal->lobe_widths(0) == glm::dvec2(0.5, 0.2));
    CHECK(mean->lobe_widths(2) == glm::dvec2(std::sqrt(0.1)));

    const LightLayout layout(3, LightKind::full);
    const auto data = [&](const MaterialPtr& material) {
        const ResponseTable table(*material, layout, 3);
        return std::vector<float>(table.data().begin(), table.data().end());
    };
    const std::vector<float> expected = data(mean);
    CHECK(data(metal) == expected);
    CHECK(data(twosided(metal)) == expected);
    // Materials composed of the metal are anisotropic, too.
    const auto half = [](const MaterialPtr& material) {
        return blend(material, diffuse({0.1}), constant_texture({0.5, 0.5, 0.5, 1}, 1));
    };
    CHECK(half(metal)->anisotropic());
    CHECK_FALSE(half(mean)->anisotropic());
    CHECK(half(metal)->lobe_widths(0) == glm::dvec2(0.5, 0.2));
    CHECK(data(half(metal)) == data(half(mean)));
}
