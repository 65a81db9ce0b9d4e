// SPDX-License-Identifier: MIT
// Tests of bounced light in single directions.
#include "shading/bounced_light.hpp"

#include <algorithm>
#include <complex>

#include "harmonics/evaluate.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("the light of surfaces in a direction is the quotient of interpolated sums of harmonics") {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> number(-1, 1);
    constexpr int order = 3, channels = 3;  // the last one is coverage
    const LightLayout layout(order, LightKind::linear);
    VertexLight rows(layout, channels, 3);
    for (int c = 0; c < channels; ++c)
        for (Lanes& lanes : rows.block(0, c))
            for (float& value : lanes.value) value = number(random);
    // Enough even light that the sums are positive in every direction.
    for (int c = 0; c < channels; ++c)
        for (float& value : rows.block(0, c).front().value) value = 9;
    VertexLight numbers(layout, channels, 3);
    for (int c = 0; c < channels; ++c) std::ranges::copy(rows.block(0, c), numbers.block(0, c).begin());
    rows.to_rows(0);

    std::array<Lanes, 3> weights;
    LaneLight light;
    Lanes factors;
    for (std::size_t i = 0; i < kLanes; ++i) {
        weights[0][i] = static_cast<float>(i) / kLanes;
        weights[1][i] = 0.7F * (1 - weights[0][i]);
        weights[2][i] = 0.3F * (1 - weights[0][i]);
        put(light.towards, i, glm::normalize(glm::vec3(number(random), number(random), number(random))));
        factors[i] = 2 + number(random);
    }
    light.irradiance.resize(1);
    for (Lanes& component : light.irradiance[0]) component.value.fill(0.25F);
    BouncedLight bounced(layout, rows);
    bounced.take(std::vector<Corners>(kLanes, {2, 0, 1}), weights);
    bounced.add_to(factors, light);

    REQUIRE(light.irradiance.size() == channels - 1);
    std::vector<double> scalar(psh_count(order));
    std::vector<std::complex<double>> spin2(scalar.size());
    for (std::size_t i = 0; i < kLanes; ++i) {
        harmonics_at(order, -glm::dvec3(vector_at(light.towards, i)), scalar, spin2);  // as light travels
        std::array<double, channels> sums{};
        for (int c = 0; c < channels; ++c) {
            double& sum = sums[static_cast<std::size_t>(c)];
            std::size_t j = 0;
            for (const std::vector<LightLayout::Harmonic>& group : {layout.even(), layout.odd()})
                for (const LightLayout::Harmonic& harmonic : group) {
                    const Lanes& of = numbers.block(0, c)[j++];
                    const float mean = weights[0][i] * of[2] + weights[1][i] * of[0] + weights[2][i] * of[1];
                    sum += double{mean} * scalar[psh_index(harmonic.l, harmonic.m)];
                }
        }
        for (std::size_t c = 0; c < channels - 1; ++c) {
            const std::array<Lanes, 4>& stokes = light.irradiance[c];
            const double expected = 0.25 + double{factors[i]} * sums[c] / sums[channels - 1];
            CHECK(double{stokes[0][i]} == doctest::Approx(expected).epsilon(1e-5));
            CHECK(stokes[1][i] == 0.25F);
        }
    }
}

TEST_CASE("negative radiance of bounced light counts as none") {
    const LightLayout layout(1, LightKind::unpolarized);
    VertexLight rows(layout, 2, 3);
    for (int c = 0; c < 2; ++c)
        for (Lanes& lanes : rows.block(0, c)) lanes.value.fill(0);
    rows.block(0, 0).front().value.fill(-1);
    rows.to_rows(0);
    LaneLight light;
    Lanes factors;
    factors.value.fill(1);
    for (std::size_t i = 0; i < kLanes; ++i) put(light.towards, i, {0, 0, 1});
    light.irradiance.resize(1);
    for (Lanes& component : light.irradiance[0]) component.value.fill(0.5F);
    BouncedLight bounced(layout, rows);
    std::array<Lanes, 3> weights;
    for (Lanes& weight : weights) weight.value.fill(1 / 3.0F);
    bounced.take(std::vector<Corners>(kLanes, {0, 1, 2}), weights);
    bounced.add_to(factors, light);
    CHECK(light.irradiance[0][0].value.front() == 0.5F);
}
