// SPDX-License-Identifier: MIT
#include "visibility/even_irradiance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harmonics/order_gains.hpp"
#include "harmonics/psh.hpp"

namespace nicol {
namespace {

// Limits of the factor, because a truncated irradiance near 0 says nothing.
constexpr double kLeast = 0.1;
constexpr double kMost = 3;

}  // namespace

std::vector<double> zonal_irradiance(int order) {
    const OrderGains gains = cosine_gains(0, order);
    std::vector<double> out;
    out.reserve(gains.size() / 2 + 1);
    for (std::size_t l = 0; l < gains.size(); l += 2)
        out.push_back(std::sqrt((2 * static_cast<double>(l) + 1) / (4 * std::numbers::pi)) * gains[l]);
    return out;
}

EvenIrradiance::EvenIrradiance(const DirectionSet& directions, int order)
    : hidden_(directions), irradiance_(zonal_irradiance(order)) {}

void EvenIrradiance::restore(const Visibility& visibility, std::size_t vertex, const glm::vec3& unit_normal,
                             std::span<float> coefficients, std::size_t stride) const {
    if (visibility.unoccluded(vertex)) return;
    const double exact = 1 - static_cast<double>(hidden_.at(visibility, vertex, unit_normal).x);
    double truncated = 0;
    for (std::size_t k = 0; k < irradiance_.size(); ++k)
        truncated += static_cast<double>(coefficients[stride * psh_index(2 * static_cast<int>(k), 0)]) *
                     irradiance_[k];
    const auto factor =
        static_cast<float>(truncated > exact / kMost ? std::clamp(exact / truncated, kLeast, kMost) : kMost);
    for (std::size_t k = 0; k < coefficients.size(); k += stride) coefficients[k] *= factor;
}

}  // namespace nicol
