// SPDX-License-Identifier: MIT
#include "material/response_table.hpp"

#include "brute_force.hpp"
#include "chiral_material.hpp"
#include "harmonics/light_coefficients.hpp"
#include "material/lobe_quadrature.hpp"
#include "test.hpp"

using namespace nicol;
using doctest::Approx;

namespace {

const Frame upright(1.0);

}  // namespace

TEST_CASE("quadrature about a lobe integrates peaks and plain functions") {
    for (const double peak : {0.0, 0.4, 1.5, 2.0}) {
        double lobe = 0;
        double plain = 0;
        for (const QuadratureNode& node : nodes_around(peak, 0, 2, 0.01, 0.5)) {
            lobe += node.weight * 1e-4 / (1e-4 + (node.x - peak) * (node.x - peak));
            plain += node.weight * std::cos(3 * node.x);
        }
        CHECK(lobe == Approx(0.01 * (std::atan((2 - peak) / 0.01) + std::atan(peak / 0.01))).epsilon(1e-7));
        CHECK(plain == Approx(std::sin(6.0) / 3).epsilon(1e-9));
    }
}

TEST_CASE("rows times light equals the reflection integral in the angular domain") {
    struct Case {
        const char* name;
        MaterialPtr material;
        double tolerance;
    };
    const std::initializer_list<Case> cases = {
        {"diffuse", diffuse({0.5}), 1e-6},
        {"beckmann 0.4", pplastic({.alpha = 0.4}), 5e-5},
        {"ggx 0.3", pplastic({.diffuse_reflectance = {0.1}, .alpha = 0.3, .distribution = Distribution::ggx}),
         2e-5},
        {"chiral", test::chiral(pplastic({.alpha = 0.4})), 5e-5},
    };
    for (const Case& c : cases) {
        for (const LightKind kind : {LightKind::unpolarized, LightKind::linear, LightKind::full}) {
            const LightLayout layout(4, kind);
            const PshVector light = test::random_light(4, 1, static_cast<int>(kind), 11);
            const ResponseTable table(*c.material, layout, 1);
            CHECK(table.data().size() ==
                  ResponseTable::kAngles * 4 * c.material->pairings() * layout.row_size());
            for (const int angle : {0, 1, 90 * 2, 200 * 2 + 1, 250 * 2 + 1}) {
                CAPTURES(c.name, angle);
                const double theta = angle * pi / 2 / (ResponseTable::kAngles - 1);
                const glm::dvec3 viewer(std::sin(theta), 0, std::cos(theta));
                const Stokes expected = test::reflected(*c.material, 0, light, upright, viewer, 192, 384);
                CHECK(glm::distance(test::respond(table, layout, light, angle), expected) < c.tolerance);
            }
        }
    }
}

TEST_CASE("a narrow lobe is resolved: constant light gives the directional albedo") {
    // The albedo is integrated independently over facet normals, in which the lobe is smooth.
    for (const double alpha : {0.01, 0.1}) {
        const MaterialPtr material =
            pplastic({.diffuse_reflectance = {0}, .alpha = alpha, .distribution = Distribution::ggx});
        const LightLayout layout(0, LightKind::unpolarized);
        const ResponseTable table(*material, layout, 1);
        for (const int angle : {0, 7, 128 * 2, 240 * 2 + 1}) {
            const double theta = angle * pi / 2 / (ResponseTable::kAngles - 1);
            const glm::dvec3 viewer(std::sin(theta), 0, std::cos(theta));
            double albedo = 0;
            const int n = 1000;
            for (int i = 0; i < n; ++i) {
                const double u = (i + 0.5) / n;  // tan^2 = alpha^2 u / (1 - u) spreads GGX facets evenly
                const double facet = std::atan(alpha * std::sqrt(u / (1 - u)));
                for (int k = 0; k < 200; ++k) {
                    const double phi = 2 * pi * (k + 0.5) / 200;
                    const glm::dvec3 h(std::sin(facet) * std::cos(phi), std::sin(facet) * std::sin(phi),
                                       std::cos(facet));
                    const double across = glm::dot(viewer, h);
                    const glm::dvec3 light = 2 * across * h - viewer;
                    if (across <= 0 || light.z <= 0) continue;
                    const double density = 1 / (pi * alpha * alpha * std::pow(h.z, 4) *
                                                std::pow(1 + std::pow(std::tan(facet) / alpha, 2), 2));
                    // Per facet direction, d omega_i = 4 (v.h) d omega_h, and D cos d omega_h = du dphi / (2
                    // pi).
                    albedo +=
                        material->evaluate(1, light, viewer)(0, 0) * light.z * 4 * across / (density * h.z);
                }
            }
            albedo /= n * 200;
            CAPTURES(alpha, angle);
            const double row = static_cast<double>(table.rows(angle, 0)[0]) * std::sqrt(4 * pi);
            CHECK(row == Approx(albedo).epsilon(2e-3));
        }
    }
}

TEST_CASE("between its angles the table's interpolation error is small") {
    const MaterialPtr material = pplastic({.alpha = 0.1, .distribution = Distribution::ggx});
    const LightLayout layout(9, LightKind::unpolarized);
    const ResponseTable table(*material, layout, 1);
    double largest = 0;
    double error = 0;
    for (int angle = 1; angle + 1 < ResponseTable::kAngles; ++angle) {
        for (std::size_t i = 0; i < 4 * table.row_size(); ++i) {
            const double before = static_cast<double>(table.rows(angle - 1, 0)[i]);
            const double here = static_cast<double>(table.rows(angle, 0)[i]);
            const double after = static_cast<double>(table.rows(angle + 1, 0)[i]);
            largest = std::max(largest, std::abs(here));
            // The second difference divided by 8 is the interpolation error at the midpoint.
            error = std::max(error, std::abs(before - 2 * here + after) / 8);
        }
    }
    CHECK(error < 1.6e-4 * largest);
}

TEST_CASE("grey materials share one set of rows, coloured ones do not, and impossible components are known") {
    const LightLayout layout(2, LightKind::unpolarized);
    CHECK(ResponseTable(*diffuse({0.5, 0.5, 0.5}), layout, 3).channels() == 1);
    const ResponseTable coloured(*diffuse({0.5, 0.25, 0.1}), layout, 3);
    CHECK(coloured.channels() == 3);
    CHECK(coloured.rows(10, 1)[0] == Approx(coloured.rows(10, 0)[0] / 2));
    CHECK(coloured.makes(0));
    CHECK_FALSE(coloured.makes(1));
    CHECK_FALSE(coloured.makes(3));
    const ResponseTable glossy(*pplastic({}), layout, 3);
    CHECK(glossy.channels() == 1);
    CHECK(glossy.makes(1));
    CHECK(glossy.makes(2));
    CHECK_FALSE(glossy.makes(3));  // unpolarized light and a real index give no s3
    CHECK(ResponseTable(*pplastic({}), LightLayout(2, LightKind::full), 1).makes(3));
    CHECK_THROWS_AS(ResponseTable(*diffuse({0.5, 0.1}), layout, 3), Error);
}
