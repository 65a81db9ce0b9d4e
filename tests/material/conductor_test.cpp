// SPDX-License-Identifier: MIT
#include "material/conductor.hpp"

#include "directions.hpp"
#include "material/microfacet.hpp"
#include "polarization/fresnel.hpp"
#include "test.hpp"

using namespace nicol;
using doctest::Approx;

namespace {

using Complex = std::complex<double>;

}  // namespace

TEST_CASE("a facet reflects by Fresnel's matrix in frames of the half vector") {
    const struct {
        Complex eta;
        Distribution distribution;
        double alpha;
    } rows[] = {{{0.2, -3.2}, Distribution::ggx, 0.4},
                {1.5, Distribution::ggx, 0.2},
                {1.5, Distribution::beckmann, 0.2}};
    std::mt19937 random(3);
    for (const auto& [eta, distribution, alpha] : rows) {
        const bool metal = eta.imag() != 0;
        const MaterialPtr material =
            metal ? rough_conductor({.eta = {eta}, .alpha = alpha, .distribution = distribution})
                  : pplastic({.int_ior = 1.5, .ext_ior = 1, .alpha = alpha, .distribution = distribution});
        for (int i = 0; i < 200; ++i) {
            // The first pair is in mirror directions, for which the half vector is the normal.
            const glm::dvec3 light = random_direction_within(random, 1.5);
            const glm::dvec3 viewer =
                i == 0 ? glm::dvec3(-light.x, -light.y, light.z) : random_direction_within(random, 1.5);
            const glm::dvec3 half = glm::normalize(light + viewer);
            const Frame in = frame_with_x(-light, glm::cross(half, -light));
            const Frame out = frame_with_x(viewer, glm::cross(half, viewer));
            const double scale = facet_density(distribution, alpha, half.z) *
                                 facet_visibility(distribution, alpha, light.z) *
                                 facet_visibility(distribution, alpha, viewer.z) / (4 * light.z * viewer.z);
            const Mueller expected = in_rotated_frames(
                scale * fresnel_reflection(glm::dot(half, viewer), eta),
                angle_between(in, theta_phi_frame(-light)), angle_between(out, theta_phi_frame(viewer)));
            CHECK(largest_difference(material->evaluate(metal ? 0 : 1, light, viewer), expected) <=
                  1e-10 * expected(0, 0));
        }
    }
}

TEST_CASE("channels of a conductor: an index each, or a reflectance each") {
    const MaterialPtr gold = rough_conductor({.eta = metal_index("Au")});
    CHECK(gold->channels() == 3);
    const glm::dvec3 up(0, 0, 1);
    CHECK(evaluate(*gold, 0, up, up)(0, 0) > 1.8 * evaluate(*gold, 2, up, up)(0, 0));
    const MaterialPtr tinted = rough_conductor({.eta = {{0.2, -3}}, .specular_reflectance = {1, 0.5}});
    CHECK(tinted->channels() == 2);
    CHECK(tinted->terms() == 1);
    CHECK(evaluate(*tinted, 1, up, up)(0, 0) == Approx(0.5 * evaluate(*tinted, 0, up, up)(0, 0)));
    const MaterialPtr both = rough_conductor({.eta = metal_index("Au"), .specular_reflectance = {1, 0.5, 1}});
    CHECK(evaluate(*both, 1, up, up)(0, 0) == Approx(0.5 * evaluate(*gold, 1, up, up)(0, 0)));
    std::array<Mueller, 3> terms;
    const glm::dvec3 light = direction(0.8, 2);
    gold->evaluate_terms(light, up, terms);
    for (int t = 0; t < 3; ++t)
        CHECK(largest_difference(terms[static_cast<std::size_t>(t)], gold->evaluate(t, light, up)) == 0);
    gold->evaluate_terms(-light, up, terms);
    CHECK(terms[1](0, 0) == 0);
    const MaterialPtr smooth = conductor(metal_index("Ag"));
    CHECK(smooth->lobe_width(0) == kSmoothAlpha);
}

TEST_CASE("conductors out of range are named") {
    const auto message = [](const RoughConductorParameters& p) { return error_of(CALL(rough_conductor(p))); };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(message({.eta = {}}).find("eta") == 0);
    CHECK(message({.eta = {{-1, -1}}}).find("eta") == 0);
    CHECK(message({.eta = {{nan, -1}}}).find("eta") == 0);
    CHECK(message({.eta = {{1, 1}}}).find("k is") == 0);  // the convention n + ik
    for (const double tiny : {0.0, 1e-6})
        CHECK(message({.eta = {{tiny, -tiny}}}).find("1e-6 or more") != std::string::npos);
    CHECK(message({.alpha = 0.0005}).find("alpha") == 0);
    CHECK(message({.alpha_v = -0.1}).find("alpha_v") == 0);
    CHECK(message({.alpha_v = nan}).find("alpha_v") == 0);
    CHECK(message({.specular_reflectance = {2}}).find("specular_reflectance") == 0);
    CHECK(message({.eta = metal_index("Au"), .specular_reflectance = {1, 1}}).find("channels") !=
          std::string::npos);
}
