// SPDX-License-Identifier: MIT
#include "specular/lobe_tap.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>

namespace nicol {
namespace {

using std::numbers::pi;

// Returns exp(2 i c) for the angle c between `to` and `from` transported to it along their great circle.
std::complex<double> transport(const Frame& from, const Frame& to) {
    const glm::dvec3 along = to[2] - from[2] * glm::dot(to[2], from[2]);
    const glm::dvec3 arrived = to[2] * glm::dot(to[2], from[2]) - from[2];
    std::complex<double> start(glm::dot(along, from[0]), glm::dot(along, from[1]));
    std::complex<double> end(glm::dot(arrived, to[0]), glm::dot(arrived, to[1]));
    if (std::norm(start) < 1e-16) {  // the great circle is undefined: the directions are nearly equal
        start = {glm::dot(to[0], from[0]), glm::dot(to[0], from[1])};
        end = 1;
    }
    const std::complex<double> rotation = start * std::conj(end);
    const double size = std::norm(rotation);
    return size > 0 ? rotation * rotation / size : 1.0;
}

// Computes the kernels at many cosines, order by order.
void add_orders(const std::vector<double>& gain, std::span<const double> cosines, std::span<ZonalValue> out) {
    const std::size_t count = cosines.size();
    std::vector<double> p(count, 1);
    std::vector<double> p_before(count);
    std::vector<double> d(count);
    std::vector<double> d_before(count);
    std::vector<double> spin0(count);
    std::vector<double> spin2(count);
    for (std::size_t i = 0; i < count; ++i) d[i] = (1 + cosines[i]) * (1 + cosines[i]) / 4;
    for (std::size_t k = 0; k < gain.size(); ++k) {
        const auto l = static_cast<double>(k);
        const double scale = gain[k] * (2 * l + 1) / (4 * pi);
        const double p_now = (2 * l + 1) / (l + 1);
        const double p_last = l / (l + 1);
        for (std::size_t i = 0; i < count; ++i) {
            spin0[i] += scale * p[i];
            const double next = p_now * cosines[i] * p[i] - p_last * p_before[i];
            p_before[i] = p[i];
            p[i] = next;
        }
        if (k < 2) continue;
        const double divisor = l * ((l + 1) * (l + 1) - 4);
        const double d_now = (2 * l + 1) * l * (l + 1) / divisor;
        const double d_constant = 4 * (2 * l + 1) / divisor;
        const double d_last = (l + 1) * (l * l - 4) / divisor;
        for (std::size_t i = 0; i < count; ++i) {
            spin2[i] += scale * d[i];
            const double next = (d_now * cosines[i] - d_constant) * d[i] - d_last * d_before[i];
            d_before[i] = d[i];
            d[i] = next;
        }
    }
    for (std::size_t i = 0; i < count; ++i) out[i] = {spin0[i], spin2[i]};
}

}  // namespace

ZonalValue zonal_sum(const std::vector<double>& gain, double cosine) {
    ZonalValue sum{};
    add_orders(gain, std::span(&cosine, 1), std::span(&sum, 1));
    return sum;
}

ZonalKernel::ZonalKernel(const std::vector<double>& gain) {
    const std::size_t steps = std::max<std::size_t>(2048, 32 * gain.size());
    std::vector<double> cosines;
    for (std::size_t i = 0; i <= steps; ++i) {
        const double distance = 2.0 * static_cast<double>(i) / static_cast<double>(steps);
        cosines.push_back(1 - distance * distance / 2);
    }
    std::vector<ZonalValue> values(cosines.size());
    add_orders(gain, cosines, values);
    for (const ZonalValue& value : values)
        table_.push_back({static_cast<float>(value.spin0), static_cast<float>(value.spin2)});
}

TapResponse tap_response(const Tap& tap, const ZonalValue& k, const Frame& from) {
    return {k.spin0, k.spin2 * std::conj(transport(from, tap.frame))};
}

}  // namespace nicol
