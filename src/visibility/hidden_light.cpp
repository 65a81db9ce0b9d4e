// SPDX-License-Identifier: MIT
#include "visibility/hidden_light.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>

#include "simd/dispatch.hpp"
#include "visibility/bundle_bits.hpp"

namespace nicol {
namespace {

[[gnu::always_inline]] inline void add_hidden(std::size_t bundles, const RayBundle* bundle,
                                              const Lanes* weights, const std::uint64_t* words,
                                              const std::uint8_t* above, const glm::vec3& normal,
                                              glm::vec4& sum) {
    std::array<Lanes, 4> sums{};
    for (std::size_t b = 0; b < bundles; ++b) {
        const std::uint32_t seen = bundle_bits(words, b);
        if (above[b] == 0 || seen == 0xFFFF) continue;  // would add zeros
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float x = bundle[b].x[i];
            const float y = bundle[b].y[i];
            const float z = bundle[b].z[i];
            const float cosine = normal.x * x + normal.y * y + normal.z * z;
            const float hidden = (seen >> i & 1U) == 0 ? weights[b].value[i] : 0.0F;
            const float weight = hidden * (cosine > 0 ? cosine : 0.0F);
            sums[0].value[i] += weight;
            sums[1].value[i] += weight * x;
            sums[2].value[i] += weight * y;
            sums[3].value[i] += weight * z;
        }
    }
    for (std::size_t i = 0; i < kLanes; ++i)
        sum += glm::vec4(sums[0].value[i], sums[1].value[i], sums[2].value[i], sums[3].value[i]);
}

}  // namespace

static_assert(RayBundle::kRays == kLanes);

HiddenLight::HiddenLight(const DirectionSet& directions)
    : directions_(directions), cones_(directions), weights_(directions.bundles().size()) {
    for (std::size_t i = 0; i < directions.size(); ++i)
        weights_[i / kLanes][i % kLanes] = directions.weights()[i] / std::numbers::pi_v<float>;
}

glm::vec4 HiddenLight::at(const Visibility& visibility, std::size_t vertex,
                          const glm::vec3& unit_normal) const {
    glm::vec4 sum(0);
    if (visibility.unoccluded(vertex)) return sum;
    std::array<std::uint8_t, DirectionSet::kMost / RayBundle::kRays> above;  // set by find_above()
    cones_.find_above(unit_normal, std::span(above).first(weights_.size()));
    dispatch<add_hidden>(weights_.size(), directions_.bundles().data(), weights_.data(),
                         visibility.at(vertex).data(), above.data(), unit_normal, sum);
    return sum;
}

double HiddenLight::magnitude(const glm::vec4& difference) {
    const glm::vec3 moment(difference.y, difference.z, difference.w);
    return static_cast<double>(std::max(std::abs(difference.x), glm::length(moment)));
}

}  // namespace nicol
