// SPDX-License-Identifier: MIT
#include "directions.hpp"
#include "material/material.hpp"
#include "material/microfacet.hpp"
#include "polarization/fresnel.hpp"
#include "test.hpp"

using namespace nicol;
using doctest::Approx;

namespace {

PplasticParameters rough(Distribution distribution, double alpha) {
    return {.diffuse_reflectance = {0.4},
            .int_ior = 1.5,
            .ext_ior = 1,
            .alpha = alpha,
            .distribution = distribution};
}

}  // namespace

TEST_CASE("facet densities are normalised and projected areas add up") {
    for_all({Distribution::beckmann, Distribution::ggx}, {0.1, 0.3, 1.0},
            [&](Distribution distribution, double alpha) {
                double area = 0;
                const int n = 20000;
                for (int i = 0; i < n; ++i) {
                    const double theta = (i + 0.5) * pi / 2 / n;
                    area += facet_density(distribution, alpha, std::cos(theta)) * std::cos(theta) *
                            std::sin(theta);
                }
                CHECK(area * 2 * pi * pi / 2 / n == Approx(1).epsilon(1e-4));
                CHECK(facet_visibility(distribution, alpha, 1) == Approx(1));
                CHECK(facet_visibility(distribution, alpha, 1e-6) < 1e-4);
                CHECK(facet_visibility(distribution, alpha, 0) == 0);
            });
    // Smith's integral for GGX: the visible projected area of all facets equals that of the surface.
    const double alpha = 0.4;
    const glm::dvec3 view = direction(1.1, 0);
    double seen = 0;
    const int n = 600;
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < n; ++k) {
            const double theta = (i + 0.5) * pi / 2 / n;
            const glm::dvec3 facet = direction(theta, 2 * pi * (k + 0.5) / n);
            const double cosine = std::max(0.0, glm::dot(facet, view));
            seen += facet_density(Distribution::ggx, alpha, facet.z) * cosine * std::sin(theta);
        }
    }
    seen *= pi / 2 / n * 2 * pi / n * facet_visibility(Distribution::ggx, alpha, view.z);
    CHECK(seen == Approx(view.z).epsilon(1e-3));
}

TEST_CASE("the base's first element is kd / pi (1 - R_i)(1 - R_o)") {
    const MaterialPtr material = pplastic(rough(Distribution::ggx, 0.2));
    for_all({0.1, 0.8, 1.4}, {0.3, 1.2}, [&](double in, double out) {
        const double expected = (1 - fresnel_reflection(std::cos(in), 1.5)(0, 0)) *
                                (1 - fresnel_reflection(std::cos(out), 1.5)(0, 0)) / pi;
        CHECK(material->evaluate(0, direction(in, 2), direction(out, 0))(0, 0) == Approx(expected));
    });
    CHECK(material->weight(0, 0) == 0.4);
}

TEST_CASE(
    "a glossy reflection at Brewster's angle is polarized across the plane of incidence, the base along it") {
    const MaterialPtr material = pplastic(rough(Distribution::ggx, 0.1));
    const double brewster = std::atan(1.5);
    const Stokes white(1, 0, 0, 0);
    const Stokes glossy = material->evaluate(1, direction(brewster, pi), direction(brewster, 0)) * white;
    CHECK(glossy[1] == Approx(-glossy[0]));  // theta-hat lies in the plane of incidence
    const Stokes refracted = material->evaluate(0, direction(0.5, 1), direction(brewster, 0)) * white;
    CHECK(refracted[1] > 0.05 * refracted[0]);
    CHECK(refracted[2] == Approx(0));
}

TEST_CASE("parameters out of range are named") {
    const auto bad = ErrorCode::invalid_argument;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    check_error(bad, CALL(pplastic({.diffuse_reflectance = {1.5}})), "diffuse_reflectance");
    check_error(bad, CALL(pplastic({.diffuse_reflectance = {}})), "diffuse_reflectance");
    check_error(bad, CALL(pplastic({.specular_reflectance = {-1}})), "specular_reflectance");
    check_error(bad, CALL(pplastic({.int_ior = 0})), "int_ior");
    check_error(bad, CALL(pplastic({.ext_ior = -1})), "ext_ior");
    check_error(bad, CALL(pplastic({.alpha = 0})), "alpha");
    check_error(bad, CALL(pplastic({.alpha = nan})), "alpha");
    check_error(bad, CALL(pplastic({.alpha_v = 2})), "alpha_v");
    check_error(bad, CALL(pplastic({.diffuse_reflectance = {.1, .2}, .specular_reflectance = {.1, .2, .3}})),
                "channels");
    CHECK_THROWS_AS(diffuse({2}), Error);
}
