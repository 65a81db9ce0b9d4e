// SPDX-License-Identifier: MIT
// Tests of response energies against the results of randomly rotated light.
#include "material/response_power.hpp"
#include "harmonics/light_coefficients.hpp"

#include <algorithm>
#include <functional>
#include <glm/gtc/quaternion.hpp>

#include "harmonics/rotation.hpp"
#include "material/conductor.hpp"
#include "material/plastic.hpp"
#include "material/principled.hpp"
#include "material/response_table.hpp"
#include "material/shared_terms.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr int order = 4;

PshVector light_of(int l, int component) {
    PshVector light(order, 1);
    for (int m = -l; m <= l; ++m) {
        light.at(0, l, m, component) = std::cos(3 * m + 1.0);
        if (component == 1) light.at(0, l, m, 2) = std::sin(2 * m + 0.5);
    }
    return light;
}

double energy(const PshVector& light) {
    double sum = 0;
    for (const double value : light.data()) sum += value * value;
    return sum;
}

// Returns the mean squares of s0 and of (s1, s2) over rotations of the light and over outgoing angles,
// weighted by projected area.
std::array<double, 2> mean_squares(const ResponseTable& table, const LightLayout& layout,
                                   const PshVector& light) {
    constexpr int rotations = 4000;
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    std::array<double, 2> sum{};
    for (int i = 0; i < rotations; ++i) {
        const glm::dquat q =
            glm::normalize(glm::dquat{normal(random), normal(random), normal(random), normal(random)});
        const auto z = test::light_pairs(layout, rotated(light, glm::mat3_cast(q)).channel(0));
        const double theta = std::acos(std::sqrt(uniform(random)));
        const auto angle = static_cast<int>(theta / std::acos(0.0) * (ResponseTable::kAngles - 1));
        const Stokes s = test::rows_times_light(table.rows(angle, 0), z);
        for (int p = 0; p < 3; ++p) sum[p == 0 ? 0 : 1] += s[p] * s[p] / rotations;
    }
    return sum;
}

}  // namespace

TEST_CASE("rotated light gives the mean square that the energies say") {
    const MaterialPtr material = pplastic({.diffuse_reflectance = {0.2}, .alpha = 0.3});
    const LightLayout layout(order, LightKind::full);
    const ResponseTable table(*material, layout, 1);
    ResponsePower::KnownTerms known;
    const ResponsePower power(*material, order, LightKind::full, 1, known);
    const auto check = [&](int l, int component, std::size_t part, double half) {
        const PshVector light = light_of(l, component);
        const auto measured = mean_squares(table, layout, light);
        CAPTURES(l, component);
        for (std::size_t output = 0; output < 2; ++output) {
            const double predicted =
                half * energy(light) * power.of(0, output, part)[static_cast<std::size_t>(l)] / (2 * l + 1);
            CHECK(measured[output] == doctest::Approx(predicted).epsilon(0.15));
        }
    };
    for (const int l : {1, 2, 4}) check(l, 0, 0, 1.0);
    for (const int l : {2, 3, 4}) check(l, 1, 1, 0.5);
}

TEST_CASE("energies of what a light lacks are zero, and channels have their own") {
    const MaterialPtr material = pplastic({.diffuse_reflectance = {0.8, 0.2, 0.0}, .alpha = 0.2});
    ResponsePower::KnownTerms known;
    const ResponsePower power(*material, 6, LightKind::unpolarized, 3, known);
    REQUIRE(power.channels() == 3);
    CHECK(power.of(0, 0, 0)[1] > 2 * power.of(2, 0, 0)[1]);
    CHECK(power.of(0, 1, 0)[3] ==
          doctest::Approx(power.of(2, 1, 0)[3]).epsilon(0.05));  // the gloss is colourless
    for (const std::size_t part : {1U, 2U})
        for (const double value : power.of(1, 0, part)) CHECK(value == 0);
    CHECK(ResponsePower(*diffuse({0.5}), 6, LightKind::unpolarized, 3, known).channels() == 1);
}

TEST_CASE("tables of materials whose terms differ by weights alone share rows") {
    struct Case {
        const char* name;
        std::function<MaterialPtr(const std::vector<double>& color, double shape)> make;
    };
    const LightLayout layout(order, LightKind::linear);
    for (const Case& c :
         {Case{"pplastic",
               [](const auto&color, double alpha) {
                   return pplastic({.diffuse_reflectance = color, .alpha = alpha});
               }},
          Case{
              "roughconductor",
              [](const auto&color, double alpha) {
                  return rough_conductor({.eta = {{0.2, -3}}, .specular_reflectance = color, .alpha = alpha});
              }},
          Case{"roughplastic, two-sided",
               [](const auto&color, double alpha) {
                   return twosided(
                       plastic({.diffuse_reflectance = color, .alpha = alpha, .nonlinear = true}));
               }},
          Case{"principled", [](const auto&color, double roughness) {
                   return principled({.base_color = color, .roughness = roughness, .metallic = 0.5});
               }}}) {
        CAPTURE(c.name);
        const MaterialPtr red = c.make({0.9, 0.1, 0.2}, 0.4), green = c.make({0.1, 0.8, 0.3}, 0.4),
                          rough = c.make({0.1, 0.8, 0.3}, 0.5);
        CHECK(terms_key(*red) == terms_key(*green));
        CHECK(terms_key(*rough) != terms_key(*green));
        const std::vector<MaterialPtr> all{red, rough, green};
        CHECK(groups_by_terms(all) == std::vector<std::vector<std::size_t>>{{0, 2}, {1}});
        KnownByTerms<ResponseTable::KnownRows> known(all);
        CHECK(known.of(*rough) == nullptr);
        REQUIRE(known.of(*red) != nullptr);
        CHECK(known.of(*red) == known.of(*green));
        for (const MaterialPtr& material : all) {
            const ResponseTable alone(*material, layout, 3);
            const ResponseTable shared(*material, layout, 3, known.of(*material));
            CHECK(std::ranges::equal(alone.data(), shared.data()));
        }
    }
}

TEST_CASE("materials whose terms differ by weights alone share their integrals") {
    const auto energies = [](const PplasticParameters& parameters, ResponsePower::KnownTerms& known) {
        return ResponsePower(*pplastic(parameters), order, LightKind::full, 3, known).of(2, 0, 0);
    };
    const PplasticParameters red{.diffuse_reflectance = {0.9, 0.1, 0.2}, .alpha = 0.3},
        green{.diffuse_reflectance = {0.1, 0.8, 0.3}, .alpha = 0.3},
        rough{.diffuse_reflectance = {0.1, 0.8, 0.3}, .alpha = 0.4},
        dull{.diffuse_reflectance = {0.1, 0.8, 0.3}, .specular_reflectance = {0}, .alpha = 0.3};
    ResponsePower::KnownTerms known;
    static_cast<void>(energies(dull, known));
    for (const PplasticParameters& each : {red, green, rough}) {
        ResponsePower::KnownTerms none;
        CHECK(energies(each, known) == energies(each, none));
    }
    CHECK(known.size() == 3);
}
