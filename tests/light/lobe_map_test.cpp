// SPDX-License-Identifier: MIT
#include "light/lobe_map.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "light/random_field.hpp"
#include "nicol/error.hpp"
#include "nicol/evaluate.hpp"

using namespace nicol;

namespace {

constexpr double pi = std::numbers::pi;

/// Light with a spectrum between those of a studio's lamps (flat) and of nature (1 / l^2).
PshVector decaying_field(int order, int channels) {
    PshVector field = random_field(order, channels, 5);
    for (int c = 0; c < channels; ++c)
        for (int l = 0; l <= order; ++l)
            for (int m = -l; m <= l; ++m)
                for (int p = 0; p < 4; ++p) field.at(c, l, m, p) /= l + 1;
    return field;
}

PshVector times(const PshVector& field, const std::vector<double>& gains) {
    PshVector out = field;
    for (int c = 0; c < field.channels(); ++c)
        for (int l = 0; l <= field.order(); ++l)
            for (int m = -l; m <= l; ++m)
                for (int p = 0; p < 4; ++p)
                    out.at(c, l, m, p) *=
                        l < static_cast<int>(gains.size()) ? gains[static_cast<std::size_t>(l)] : 0;
    return out;
}

/// Poles, their surroundings, the seam at phi = 0, and all over the sphere.
std::vector<glm::dvec3> directions() {
    std::vector<glm::dvec3> out{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}};
    for (const double theta : {1e-4, 0.01, pi - 0.01, pi - 1e-4})
        for (const double phi : {0.0, 1.0, 4.0})
            out.emplace_back(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                             std::cos(theta));
    for (const double phi : {-1e-7, -1e-3, 1e-3}) out.emplace_back(std::cos(phi), std::sin(phi), 0.0);
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    while (out.size() < 2000)
        out.push_back(glm::normalize(glm::dvec3(normal(random), normal(random), normal(random))));
    return out;
}

}  // namespace

TEST_CASE("a look-up is the filtered light, in any frame") {
    std::vector<double> gains(65);
    for (std::size_t l = 5; l <= 64; ++l)
        gains[l] = std::exp(-0.5 * static_cast<double>(l * (l + 1)) * 0.05 * 0.05);
    const PshVector light = decaying_field(64, 5);
    const PshVector expected = times(light, gains);
    for (const bool polarized : {false, true}) {
        const LobeMap map(light, gains, polarized);
        REQUIRE(map.channels() == 5);
        CHECK(map.layers() == (polarized ? 10 : 2));
        CHECK(map.texels(0, map.layers()).size() * sizeof(float) == map.bytes());
        std::vector<glm::vec4> found(5);
        glm::dvec4 error(0);
        glm::dvec4 power(0);
        double largest = 0;
        double worst = 0;
        for (const glm::dvec3& d : directions()) {
            const glm::dvec3 hint = std::abs(d.x) < 0.8 ? glm::dvec3(1, 0.2, 0) : glm::dvec3(0, 0, 1);
            const Frame frame = frame_with_x(d, hint);
            map.look_up(glm::vec3(d), glm::vec3(frame[0]), found);
            for (int c = 0; c < 5; ++c) {
                Stokes s = turned(evaluate(expected, c, d), angle_between(theta_phi_frame(d), frame));
                if (!polarized) s = {s[0], 0, 0, 0};
                const Stokes difference = Stokes(found[static_cast<std::size_t>(c)]) - s;
                error += difference * difference;
                power += s * s;
                worst = std::max(worst, glm::length(difference));
                largest = std::max(largest, glm::length(s));
            }
        }
        for (int p = 0; p < (polarized ? 4 : 1); ++p)
            CHECK(std::sqrt(error[p] / power[p]) < 1.2 * LobeMap::kTolerance);
        if (!polarized) CHECK(error[1] + error[2] + error[3] == 0);
        CHECK(worst < 4 * LobeMap::kTolerance * largest);
    }
}

TEST_CASE("grids are as fine as the filtered light needs") {
    const PshVector light = decaying_field(64, 1);
    std::vector<double> gains(65, 1.0);
    const int fine = LobeMap(light, gains, false).rows();
    for (std::size_t l = 0; l < gains.size(); ++l) gains[l] = std::exp(-static_cast<double>(l * l) * 0.02);
    const int coarse = LobeMap(light, gains, false).rows();
    CHECK(fine > 2 * coarse);
    CHECK(fine <= LobeMap::kMostRows);
    CHECK(coarse >= LobeMap::kLeastRows);
    // Darkness, and lobes that end below or beyond the light's order.
    const LobeMap dark(PshVector(9, 1), gains, true);
    CHECK(dark.rows() == LobeMap::kLeastRows);
    std::vector<glm::vec4> found(1);
    dark.look_up({0, 0.6F, 0.8F}, {1, 0, 0}, found);
    CHECK(found[0] == glm::vec4(0));
    const std::vector<double> mean{1.0};
    const PshVector bright = random_field(6, 1);
    LobeMap(bright, mean, false).look_up({0, 0.6F, 0.8F}, {1, 0, 0}, found);
    CHECK(found[0][0] == doctest::Approx(bright.at(0, 0, 0, 0) / std::sqrt(4 * pi)));
}

TEST_CASE("what no map can be made of is refused") {
    const PshVector light = random_field(4, 1);
    const std::vector<double> ones(5, 1.0);
    CHECK_THROWS_AS(LobeMap(light, {}, false), Error);
    const std::vector<double> bad{1.0, std::numeric_limits<double>::quiet_NaN()};
    CHECK_THROWS_AS(LobeMap(light, bad, false), Error);
    PshVector endless = light;
    endless.at(0, 3, 1, 0) = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS(LobeMap(endless, ones, false), Error);
}
