// SPDX-License-Identifier: MIT
#include "harmonics/mirror_harmonics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harmonics/psh.hpp"
#include "harmonics/spin_harmonics.hpp"

namespace nicol {
namespace {

constexpr double kRoot2 = std::numbers::sqrt2;

// Returns the harmonics sY_lm of each row at phi = 0.
std::vector<std::vector<double>> values(int spin, int order, const UpperRows& rows) {
    std::vector<std::vector<double>> out;
    for (std::size_t j = 0; j < rows.count(); ++j) {
        out.emplace_back(psh_count(order));
        spin_harmonics(spin, order, rows.sin_half(j), rows.cos_half(j), out.back());
    }
    return out;
}

}  // namespace

int highest_order(const std::vector<LightLayout::Harmonic>& harmonics) {
    int order = 0;
    for (const LightLayout::Harmonic& h : harmonics) order = std::max(order, h.l);
    return order;
}

std::vector<SeparatedHarmonic> separate_scalars(const std::vector<LightLayout::Harmonic>& harmonics,
                                                const UpperRows& rows) {
    const auto on_rows = values(0, highest_order(harmonics), rows);
    std::vector<SeparatedHarmonic> out;
    for (const LightLayout::Harmonic& h : harmonics) {
        SeparatedHarmonic& separated = out.emplace_back(SeparatedHarmonic{h.m, {}, {}});
        for (const auto& y : on_rows) {
            separated.first.push_back((h.m == 0 ? 1 : kRoot2) * y[psh_index(h.l, std::abs(h.m))]);
        }
    }
    return out;
}

// Separates the spin harmonics. For m > 0, s1 + i s2 is (2Y_lm e^{i m phi} + (-1)^l 2Y_l,-m e^{-i m phi}) /
// sqrt 2, so that the sum of the two terms goes with cos m phi in s1, and the difference with sin m phi in
// s2. For m < 0 the factor is -i and the second term is subtracted, so that the sum goes with sin in s1, and
// the difference with -cos in s2.
std::vector<SeparatedHarmonic> separate_spins(const std::vector<LightLayout::Harmonic>& harmonics,
                                              const UpperRows& rows) {
    const auto on_rows = values(2, highest_order(harmonics), rows);
    std::vector<SeparatedHarmonic> out;
    for (const LightLayout::Harmonic& h : harmonics) {
        SeparatedHarmonic& separated = out.emplace_back(SeparatedHarmonic{h.m, {}, {}});
        const bool odd = h.l % 2 != 0;
        for (const auto& y : on_rows) {
            const double plus = y[psh_index(h.l, std::abs(h.m))];
            const double minus = (odd ? -1 : 1) * y[psh_index(h.l, -std::abs(h.m))];
            if (h.m == 0) {
                separated.first.push_back(odd ? 0.0 : plus);
                separated.second.push_back(odd ? -plus : 0.0);
            } else {
                separated.first.push_back((plus + minus) / kRoot2);
                separated.second.push_back((h.m > 0 ? 1 : -1) * (plus - minus) / kRoot2);
            }
        }
    }
    return out;
}

}  // namespace nicol
