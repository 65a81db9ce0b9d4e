// SPDX-License-Identifier: MIT
// Coefficient vectors of polarized spherical harmonics.
#include "harmonics/psh.hpp"

#include <algorithm>

#include "harmonics/require.hpp"

namespace nicol {
namespace {

std::size_t offset(const PshVector& v, int c) {
    if (c < 0 || c >= v.channels())
        refuse("channel is " + std::to_string(c) + ", the vector has " + std::to_string(v.channels()));
    return static_cast<std::size_t>(c) * 4 * psh_count(v.order());
}

std::size_t offset(const PshVector& v, int c, int l, int m, int p) {
    if (l < 0 || l > v.order() || m < -l || m > l || p < 0 || p > 3)
        refuse("coefficient (l, m, p) = (" + std::to_string(l) + ", " + std::to_string(m) + ", " +
               std::to_string(p) + ") is outside order " + std::to_string(v.order()));
    return offset(v, c) + 4 * psh_index(l, m) + static_cast<std::size_t>(p);
}

}  // namespace

PshVector::PshVector(int order, int channels) : order_(order), channels_(channels) {
    require_order(order);
    require(channels >= 1, "channels is " + std::to_string(channels) + ", expected at least 1");
    const std::size_t per_channel = 4 * psh_count(order);
    require(static_cast<std::size_t>(channels) <= data_.max_size() / per_channel,
            "channels is " + std::to_string(channels) + ", more than memory can hold");
    data_.assign(static_cast<std::size_t>(channels) * per_channel, 0.0);
}

std::span<double> PshVector::channel(int c) {
    return {data_.data() + offset(*this, c), 4 * psh_count(order_)};
}

std::span<const double> PshVector::channel(int c) const {
    return {data_.data() + offset(*this, c), 4 * psh_count(order_)};
}

double& PshVector::at(int c, int l, int m, int p) {
    return data_[offset(*this, c, l, m, p)];
}

double PshVector::at(int c, int l, int m, int p) const {
    return data_[offset(*this, c, l, m, p)];
}

PshVector with_order(const PshVector& field, int order) {
    PshVector out(order, field.channels());
    const std::size_t count = 4 * psh_count(std::min(order, field.order()));
    for (int c = 0; c < field.channels(); ++c) {
        std::ranges::copy(field.channel(c).first(count), out.channel(c).begin());
    }
    return out;
}

void scale_orders(PshVector& field, std::span<const double> gains) {
    require(gains.size() == static_cast<std::size_t>(field.order()) + 1,
            std::to_string(gains.size()) + " gains, a field of order " + std::to_string(field.order()) +
                " needs " + std::to_string(field.order() + 1));
    for (int c = 0; c < field.channels(); ++c) {
        auto value = field.channel(c).begin();
        for (std::size_t l = 0; l < gains.size(); ++l) {
            for (std::size_t i = 0; i < 4 * (2 * l + 1); ++i) *value++ *= gains[l];
        }
    }
}

}  // namespace nicol
