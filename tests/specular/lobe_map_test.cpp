// SPDX-License-Identifier: MIT
#include "specular/lobe_map.hpp"

#include "light/images.hpp"
#include "specular/look_up.hpp"
#include "test.hpp"

using namespace nicol;
using test::look_up;

namespace {

/// Returns light whose spectrum lies between those of studio lamps (flat) and of nature (1 / l^2).
PshVector decaying_field(int order, int channels) {
    PshVector field = random_field(order, channels, 5);
    std::vector<double> gains;
    for (int l = 0; l <= order; ++l) gains.push_back(1.0 / (l + 1));
    scale_orders(field, gains);
    return field;
}

/// Returns directions at the poles, near them, at the seam phi = 0, and all over the sphere.
std::vector<glm::dvec3> directions() {
    std::vector<glm::dvec3> out{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}};
    for (const double theta : {1e-4, 0.01, pi - 0.01, pi - 1e-4})
        for (const double phi : {0.0, 1.0, 4.0}) out.push_back(direction(theta, phi));
    for (const double phi : {-1e-7, -1e-3, 1e-3}) out.push_back(direction(pi / 2, phi));
    for (const glm::dvec3& d : random_directions(1980, 3)) out.push_back(d);
    return out;
}

}  // namespace

TEST_CASE("a look-up is the filtered light, in any frame") {
    std::vector<double> gains(65);
    for (std::size_t l = 5; l <= 64; ++l)
        gains[l] = std::exp(-0.5 * static_cast<double>(l * (l + 1)) * 0.05 * 0.05);
    const PshVector light = decaying_field(64, 5);
    PshVector expected = light;
    scale_orders(expected, gains);
    for (const bool polarized : {false, true}) {
        const LobeMap map(light, gains, polarized);
        REQUIRE(map.channels() == 5);
        CHECK(map.layers() == (polarized ? 10 : 2));
        CHECK(map.texels().size_bytes() == map.bytes());
        glm::dvec4 error(0);
        glm::dvec4 power(0);
        double largest = 0;
        double worst = 0;
        for (const glm::dvec3& d : directions()) {
            const glm::dvec3 hint = std::abs(d.x) < 0.8 ? glm::dvec3(1, 0.2, 0) : glm::dvec3(0, 0, 1);
            const Frame frame = frame_with_x(d, hint);
            for (int c = 0; c < 5; ++c) {
                Stokes s = rotated(evaluate(expected, c, d), angle_between(theta_phi_frame(d), frame));
                if (!polarized) s = {s[0], 0, 0, 0};
                const Stokes difference = look_up(map, c, d, frame[0]) - s;
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
    // Darkness needs the smallest map, and lobes may end below or above the light's order.
    const LobeMap dark(PshVector(9, 1), gains, true);
    CHECK(dark.rows() == LobeMap::kLeastRows);
    CHECK(look_up(dark, 0, {0, 0.6, 0.8}, {1, 0, 0}) == Stokes(0));
    const std::vector<double> mean{1.0};
    const PshVector bright = random_field(6, 1);
    CHECK(look_up(LobeMap(bright, mean, false), 0, {0, 0.6, 0.8}, {1, 0, 0})[0] ==
          doctest::Approx(bright.at(0, 0, 0, 0) / std::sqrt(4 * pi)));
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
