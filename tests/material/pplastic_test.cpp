// SPDX-License-Identifier: MIT
#include "directions.hpp"
#include "material/material.hpp"
#include "material/microfacet.hpp"
#include "polarization/fresnel.hpp"
#include "test.hpp"

using namespace nicol;
using doctest::Approx;

namespace {

Mueller total(const Material& material, const glm::dvec3& light, const glm::dvec3& viewer) {
    Mueller m;
    for (int t = 0; t < material.terms(); ++t)
        m = m + material.weight(t, 0) * material.evaluate(t, light, viewer);
    return m;
}

PplasticParameters rough(Distribution distribution, double alpha) {
    return {.diffuse_reflectance = {0.4},
            .int_ior = 1.5,
            .ext_ior = 1,
            .alpha = alpha,
            .distribution = distribution};
}

}  // namespace

TEST_CASE("facet densities are normalised and projected areas add up") {
    for (const Distribution distribution : {Distribution::beckmann, Distribution::ggx}) {
        for (const double alpha : {0.1, 0.3, 1.0}) {
            double area = 0;
            const int n = 20000;
            for (int i = 0; i < n; ++i) {
                const double theta = (i + 0.5) * pi / 2 / n;
                area +=
                    facet_density(distribution, alpha, std::cos(theta)) * std::cos(theta) * std::sin(theta);
            }
            CHECK(area * 2 * pi * pi / 2 / n == Approx(1).epsilon(1e-4));
            CHECK(facet_visibility(distribution, alpha, 1) == Approx(1));
            CHECK(facet_visibility(distribution, alpha, 1e-6) < 1e-4);
            CHECK(facet_visibility(distribution, alpha, 0) == 0);
        }
    }
    // Smith's integral for GGX: the visible projected area of all facets is the macro surface's.
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
    for (const double in : {0.1, 0.8, 1.4}) {
        for (const double out : {0.3, 1.2}) {
            const double expected = (1 - fresnel_reflection(std::cos(in), 1.5)(0, 0)) *
                                    (1 - fresnel_reflection(std::cos(out), 1.5)(0, 0)) / pi;
            CHECK(material->evaluate(0, direction(in, 2), direction(out, 0))(0, 0) == Approx(expected));
        }
    }
    CHECK(material->weight(0, 0) == 0.4);
}

TEST_CASE("in the mirror direction the boundary is Fresnel's reflection scaled by D G / 4 cos^2") {
    const double zenith = 0.9;
    for (const Distribution distribution : {Distribution::beckmann, Distribution::ggx}) {
        const MaterialPtr material = pplastic(rough(distribution, 0.2));
        const Mueller m = material->evaluate(1, direction(zenith, pi), direction(zenith, 0));
        const double g = std::pow(facet_visibility(distribution, 0.2, std::cos(zenith)), 2);
        const double scale = facet_density(distribution, 0.2, 1) * g / (4 * std::pow(std::cos(zenith), 2));
        // The plane of incidence holds theta-hat, so the s-axis is phi-hat: x rotated by 90 degrees.
        const Mueller expected =
            in_rotated_frames(scale * fresnel_reflection(std::cos(zenith), 1.5), pi / 2, pi / 2);
        for (std::size_t i = 0; i < 16; ++i)
            CHECK(m(i / 4, i % 4) == Approx(expected(i / 4, i % 4)).epsilon(1e-9));
    }
}

TEST_CASE(
    "a glossy reflection at Brewster's angle is polarized across the plane of incidence, the base along it") {
    const MaterialPtr material = pplastic(rough(Distribution::ggx, 0.1));
    const double brewster = std::atan(1.5);
    const Stokes white(1, 0, 0, 0);
    const Stokes glossy = material->evaluate(1, direction(brewster, pi), direction(brewster, 0)) * white;
    CHECK(glossy[1] == Approx(-glossy[0]));  // theta-hat lies in the plane
    const Stokes refracted = material->evaluate(0, direction(0.5, 1), direction(brewster, 0)) * white;
    CHECK(refracted[1] > 0.05 * refracted[0]);
    CHECK(refracted[2] == Approx(0));
}

TEST_CASE("reciprocity: exchanging light and viewer transposes, with s2 mirrored") {
    const MaterialPtr material = pplastic(rough(Distribution::beckmann, 0.3));
    const glm::dvec3 a = direction(0.7, 0.4);
    const glm::dvec3 b = direction(1.2, 2.9);
    // Reversing a ray keeps x = theta-hat up to sign and reverses y: (s0, s1, -s2, s3).
    const Mueller forth = total(*material, a, b);
    const Mueller back = total(*material, b, a);
    const double flip[4] = {1, 1, -1, 1};
    for (std::size_t p = 0; p < 4; ++p) {
        for (std::size_t q = 0; q < 4; ++q) CHECK(forth(p, q) == Approx(flip[p] * flip[q] * back(q, p)));
    }
}

TEST_CASE("below the horizon on either side there is nothing") {
    for (const MaterialPtr& material : {pplastic({}), diffuse({0.5})}) {
        CHECK(total(*material, direction(2, 0), direction(1, 0))(0, 0) == 0);
        CHECK(total(*material, direction(1, 0), direction(2, 0))(0, 0) == 0);
        CHECK(total(*material, direction(1, 0), direction(1, 2))(0, 0) > 0);
    }
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
    check_error(bad, CALL(pplastic({.diffuse_reflectance = {.1, .2}, .specular_reflectance = {.1, .2, .3}})),
                "channels");
    CHECK_THROWS_AS(diffuse({2}), Error);
}
