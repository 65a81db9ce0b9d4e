// SPDX-License-Identifier: MIT
#include "shading/focused_light.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

using namespace nicol;

namespace {

constexpr int kAcross = 100;

/// Returns photons on a regular grid over a square of side 1 in the plane z = 0, each with two channels.
FocusedLight even_light(const glm::vec3& towards) {
    std::vector<Photon> photons;
    std::vector<float> powers;
    for (int y = 0; y < kAcross; ++y)
        for (int x = 0; x < kAcross; ++x) {
            photons.push_back({.position = {(static_cast<float>(x) + 0.5F) / kAcross,
                                            (static_cast<float>(y) + 0.5F) / kAcross, 0},
                               .normal = {0, 0, 1},
                               .towards = towards});
            powers.push_back(3.0F / (kAcross * kAcross));
            powers.push_back(1.0F / (kAcross * kAcross));
        }
    return {std::move(photons), std::move(powers), 2};
}

LaneLight gathered(const FocusedLight& focused, const glm::vec3& position, const glm::vec3& normal) {
    LaneLight out;
    focused.gather(std::array{position}, std::array{normal}, out);
    return out;
}

}  // namespace

TEST_CASE("photons light the surface that they are on, as their power over its area") {
    const glm::vec3 towards = glm::normalize(glm::vec3(1, 0, 2));
    const FocusedLight focused = even_light(towards);
    REQUIRE(focused.photons() == kAcross * kAcross);
    const LaneLight light = gathered(focused, {0.4F, 0.6F, 0}, {0, 0, 1});
    REQUIRE(light.points == 1);
    REQUIRE(light.irradiance.size() == 2);
    CHECK(glm::distance(vector_at(light.towards, 0), towards) < 1e-5F);
    // Irradiance is that of a surface which faces the light.
    CHECK(light.irradiance[0][0][0] * towards.z == doctest::Approx(3).epsilon(0.02));
    CHECK(light.irradiance[1][0][0] * towards.z == doctest::Approx(1).epsilon(0.02));
    SUBCASE("but not other surfaces") {
        CHECK(gathered(focused, {0.4F, 0.6F, 0}, {0, 0, -1}).points == 0);
        CHECK(gathered(focused, {0.4F, 0.6F, 0.1F}, {0, 0, 1}).points == 0);
        CHECK(gathered(focused, {1.4F, 0.6F, 0}, {0, 0, 1}).points == 0);
    }
}

TEST_CASE("the light that points gather is all light of the photons") {
    // Light is spread over the edge of the square.
    constexpr int across = 137;
    const FocusedLight focused = even_light({0, 0, 1});
    double sum = 0;
    for (int y = 0; y < across; ++y)
        for (int x = 0; x < across; ++x) {
            const glm::vec3 at(-0.2F + 1.4F * (static_cast<float>(x) + 0.5F) / across,
                               -0.2F + 1.4F * (static_cast<float>(y) + 0.5F) / across, 0);
            const LaneLight light = gathered(focused, at, {0, 0, 1});
            sum += static_cast<double>(light.points == 0 ? 0.0F : light.irradiance[0][0][0]);
        }
    CHECK(sum * 1.96 / (across * across) == doctest::Approx(3).epsilon(0.01));
}
