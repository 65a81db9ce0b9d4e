// SPDX-License-Identifier: MIT
#include "shading/bounced_light.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harmonics/psh.hpp"
#include "shading/light_changes.hpp"
#include "simd/lane_transpose.hpp"

namespace nicol {
namespace {

// Computes real harmonics of unit directions, see real_from_complex(): out[psh_index(l, m)].
void real_harmonics(int order, const LaneVectors& directions, std::span<Lanes> out) {
    // sin^m theta times the cosine and the sine of m phi.
    Lanes cosine, sine;
    cosine.value.fill(1);
    sine.value.fill(0);
    double of_degree = 1 / std::sqrt(4 * std::numbers::pi);  // Y_mm without sin^m theta exp(i m phi)
    for (int m = 0; m <= order; ++m) {
        // Legendre's recurrence for normalized functions.
        Lanes last, before;
        last.value.fill(static_cast<float>(of_degree));
        before.value.fill(0);
        for (int l = m; l <= order; ++l) {
            if (l > m) {
                const double l2 = double{1} * l * l, m2 = double{1} * m * m, below = (l - 1.0) * (l - 1.0);
                const auto a = static_cast<float>(std::sqrt((4 * l2 - 1) / (l2 - m2)));
                const auto b =
                    static_cast<float>(l - 1 > m ? std::sqrt((below - m2) / (4 * below - 1)) : 0.0);
                for (std::size_t i = 0; i < kLanes; ++i) {
                    const float next = a * (directions.z[i] * last[i] - b * before[i]);
                    before[i] = last[i];
                    last[i] = next;
                }
            }
            const float scale = m > 0 ? std::numbers::sqrt2_v<float> : 1.0F;
            Lanes &even = out[psh_index(l, m)], &odd = out[psh_index(l, -m)];
            for (std::size_t i = 0; i < kLanes; ++i) odd[i] = scale * last[i] * sine[i];
            for (std::size_t i = 0; i < kLanes; ++i) even[i] = scale * last[i] * cosine[i];
        }
        of_degree *= -std::sqrt((2 * m + 3) / (2 * m + 2.0));
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float c = cosine[i], s = sine[i];
            cosine[i] = c * directions.x[i] - s * directions.y[i];
            sine[i] = c * directions.y[i] + s * directions.x[i];
        }
    }
}

}  // namespace

BouncedLight::BouncedLight(const LightLayout& layout, const VertexLight& rows)
    : rows_(rows), order_(layout.order()), size_(layout.size()) {
    for (const std::vector<LightLayout::Harmonic>* const group : {&layout.even(), &layout.odd()})
        for (const LightLayout::Harmonic& harmonic : *group)
            harmonics_.push_back(psh_index(harmonic.l, harmonic.m));
    light_.resize(static_cast<std::size_t>(rows.channels()) * harmonics_.size());
}

void BouncedLight::take(std::span<const Corners> triangles, const std::array<Lanes, 3>& weights) {
    std::array<std::array<const float*, kLanes>, 3> rows;
    for (std::size_t c = 0; c < light_.size() / harmonics_.size(); ++c) {
        for (std::size_t i = 0; i < kLanes; ++i) {
            const Corners& corners = triangles[i < triangles.size() ? i : 0];
            for (glm::length_t k = 0; k < 3; ++k)
                rows[static_cast<std::size_t>(k)][i] = rows_.row(corners[k]) + c * size_;
        }
        to_lanes_weighted(rows, weights, harmonics_.size(), light_.data() + c * harmonics_.size());
    }
}

void BouncedLight::add_to(const Lanes& factors, LaneLight& light) const {
    // Coverage below which the harmonics show more of other directions than of these.
    constexpr float least = 0.5F;
    const std::size_t channels = light_.size() / harmonics_.size() - 1;
    give_channels(channels, light);
    thread_local std::vector<Lanes> harmonics;
    harmonics.resize(harmonics_.size());
    // Light is a function of the direction in which it travels.
    LaneVectors travels;
    for (std::size_t i = 0; i < kLanes; ++i) put(travels, i, -vector_at(light.towards, i));
    real_harmonics(order_, travels, harmonics);
    const auto sum_of = [&](std::size_t channel) {
        const Lanes* const own = light_.data() + channel * harmonics_.size();
        Lanes sum{};
        for (std::size_t j = 0; j < harmonics_.size(); ++j)
            for (std::size_t i = 0; i < kLanes; ++i) sum[i] += own[j][i] * harmonics[harmonics_[j]][i];
        return sum;
    };
    const Lanes coverage = sum_of(channels);
    for (std::size_t c = 0; c < light.irradiance.size(); ++c) {
        const Lanes sum = sum_of(std::min(c, channels - 1));
        for (std::size_t i = 0; i < kLanes; ++i)
            light.irradiance[c][0][i] += factors[i] * std::max(sum[i], 0.0F) / std::max(coverage[i], least);
    }
}

}  // namespace nicol
