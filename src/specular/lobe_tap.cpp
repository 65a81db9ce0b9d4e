// SPDX-License-Identifier: MIT
#include "specular/lobe_tap.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

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

}  // namespace

ZonalKernel::Value zonal_sum(const std::vector<double>& gain, double cosine) {
    ZonalKernel::Value sum{0, 0};
    double p = 1;
    double p_before = 0;
    double d = (1 + cosine) * (1 + cosine) / 4;
    double d_before = 0;
    for (std::size_t i = 0; i < gain.size(); ++i) {
        const auto l = static_cast<double>(i);
        const double scale = gain[i] * (2 * l + 1) / (4 * pi);
        sum.spin0 += scale * p;
        const double p_next = ((2 * l + 1) * cosine * p - l * p_before) / (l + 1);
        p_before = p;
        p = p_next;
        if (i < 2) continue;
        sum.spin2 += scale * d;
        const double d_next =
            ((2 * l + 1) * (l * (l + 1) * cosine - 4) * d - (l + 1) * (l * l - 4) * d_before) /
            (l * ((l + 1) * (l + 1) - 4));
        d_before = d;
        d = d_next;
    }
    return sum;
}

ZonalKernel::ZonalKernel(const std::vector<double>& gain) {
    const std::size_t steps = std::max<std::size_t>(2048, 32 * gain.size());
    for (std::size_t i = 0; i <= steps; ++i) {
        const double distance = 2.0 * static_cast<double>(i) / static_cast<double>(steps);
        table_.push_back(zonal_sum(gain, 1 - distance * distance / 2));
    }
}

ZonalKernel::Value ZonalKernel::at(double distance2) const {
    const double x = std::sqrt(std::min(distance2, 4.0)) / 2 * static_cast<double>(table_.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(x), table_.size() - 2);
    const double f = x - static_cast<double>(i);
    return {table_[i].spin0 + f * (table_[i + 1].spin0 - table_[i].spin0),
            table_[i].spin2 + f * (table_[i + 1].spin2 - table_[i].spin2)};
}

TapResponse tap_response(const Tap& tap, const ZonalKernel::Value& k, const Frame& from) {
    return {k.spin0, k.spin2 * std::conj(transport(from, tap.frame))};
}

}  // namespace nicol
