// SPDX-License-Identifier: MIT
#include "harmonics/light_layout.hpp"

#include <algorithm>
#include <string>

#include "error.hpp"

namespace nicol {

LightLayout::LightLayout(int order, LightKind kind) : order_(order), kind_(kind) {
    if (order < 0 || order > kMaxOrder) {
        throw Error(ErrorCode::invalid_argument, "order is " + std::to_string(order) +
                                                     "; it must lie in 0 to " + std::to_string(kMaxOrder));
    }
    const auto add = [this](LightKind part, int m) {
        const int lowest = std::max(part == LightKind::linear ? 2 : 0, std::abs(m));
        for (int l = lowest; l <= order_; ++l) entries_.push_back({part, l, m});
    };
    for (int m = 0; m <= order; ++m) add(LightKind::unpolarized, m);
    if (kind != LightKind::unpolarized) {
        for (int m = -order; m <= order; ++m) add(LightKind::linear, m);
    }
    if (kind == LightKind::full) {
        for (int m = 0; m <= order; ++m) add(LightKind::full, m);
    }
}

std::vector<std::complex<double>> LightLayout::pack(std::span<const double> channel) const {
    if (channel.size() < 4 * psh_count(order_)) {
        throw Error(ErrorCode::invalid_argument,
                    "a light of " + std::to_string(channel.size()) + " coefficients is shorter than order " +
                        std::to_string(order_) + " needs (" + std::to_string(4 * psh_count(order_)) + ")");
    }
    const auto at = [&channel](int l, int m, std::size_t p) { return channel[4 * psh_index(l, m) + p]; };
    std::vector<std::complex<double>> packed;
    packed.reserve(size());
    for (const Entry& e : entries_) {
        if (e.part == LightKind::linear) {
            packed.emplace_back(at(e.l, e.m, 1), at(e.l, e.m, 2));
        } else if (e.part == LightKind::unpolarized) {
            packed.emplace_back(at(e.l, e.m, 0), e.m > 0 ? at(e.l, -e.m, 0) : 0.0);
        } else {
            packed.emplace_back(e.m > 0 ? at(e.l, -e.m, 3) : 0.0, at(e.l, e.m, 3));
        }
    }
    return packed;
}

}  // namespace nicol
