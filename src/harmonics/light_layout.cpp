// SPDX-License-Identifier: MIT
#include "harmonics/light_layout.hpp"

#include <algorithm>
#include <cstdlib>
#include <numbers>
#include <string>

#include "error.hpp"

namespace nicol {
namespace {

constexpr double kRootHalf = std::numbers::sqrt2 / 2;

using Harmonic = LightLayout::Harmonic;

// Returns the harmonics with (l + m) mod 2 = odd, for odd = 0 or 1.
std::vector<Harmonic> scalar_harmonics(int order, int odd) {
    std::vector<Harmonic> out;
    for (int m = 0; m <= order; ++m) {
        for (int l = m + odd; l <= order; l += 2) out.push_back({l, m});
        for (int l = m + odd; m > 0 && l <= order; l += 2) out.push_back({l, -m});
    }
    return out;
}

// Returns the harmonics of the spin-2 part. For m = 0, even l come first, because they are cosines and odd l
// are sines.
std::vector<Harmonic> spin_group(int order) {
    std::vector<Harmonic> out;
    for (int l = 2; l <= order; l += 2) out.push_back({l, 0});
    for (int l = 3; l <= order; l += 2) out.push_back({l, 0});
    for (int m = 1; m <= order; ++m) {
        for (int l = std::max(m, 2); l <= order; ++l) out.push_back({l, m});
        for (int l = std::max(m, 2); l <= order; ++l) out.push_back({l, -m});
    }
    return out;
}

std::size_t count_of(int first, int step, int order) {
    return first > order ? 0 : static_cast<std::size_t>((order - first) / step + 1);
}

}  // namespace

LightLayout::LightLayout(int order, LightKind kind) : order_(order), kind_(kind) {
    if (order < 0 || order > kMaxOrder) {
        throw Error(ErrorCode::invalid_argument, "order is " + std::to_string(order) +
                                                     "; it must lie in 0 to " + std::to_string(kMaxOrder));
    }
    even_ = scalar_harmonics(order, 0);
    odd_ = scalar_harmonics(order, 1);
    add_scalar_terms(0);
    if (kind != LightKind::unpolarized) {
        spin_ = spin_group(order);
        add_spin_terms(false);
        add_spin_terms(true);
    }
    if (kind == LightKind::full) add_scalar_terms(3);

    std::size_t even = 0;
    std::size_t odd = even_.size();
    std::size_t spin = spin_begin();
    for (int m = 0; m <= order; ++m) add_runs(m, even, odd, spin);
    for (const Run& run : runs_) row_size_ += run.count;
}

void LightLayout::add_scalar_terms(std::size_t p) {
    for (const std::vector<Harmonic>* group : {&even_, &odd_}) {
        for (const auto& [l, m] : *group) {
            const std::size_t coefficient = 4 * psh_index(l, m) + p;
            terms_.push_back({Term{coefficient, 1}, Term{coefficient, 0}});
        }
    }
}

// Adds the terms of e, or of o if `times_i`. With f_m the coefficients of f = e + i o, and f_-m multiplied by
// (-1)^l, e has (Re f_m + Re f_-m) / sqrt 2 for cosines and (Im f_-m - Im f_m) / sqrt 2 for sines, and o has
// (Im f_m + Im f_-m) / sqrt 2 for cosines and (Re f_m - Re f_-m) / sqrt 2 for sines.
void LightLayout::add_spin_terms(bool times_i) {
    for (const auto& [l, m] : spin_) {
        const bool sine = m < 0 || (m == 0 && l % 2 != 0);
        const std::size_t component = sine != times_i ? 2 : 1;
        const double factor = sine && !times_i ? -1 : 1;
        const double image = (l % 2 == 0 ? 1 : -1) * (sine && times_i ? -1 : 1);
        const std::size_t plus = 4 * psh_index(l, std::abs(m)) + component;
        const std::size_t minus = 4 * psh_index(l, -std::abs(m)) + component;
        if (m == 0) {
            terms_.push_back({Term{plus, factor}, Term{plus, 0}});
        } else {
            terms_.push_back({Term{plus, kRootHalf * factor}, Term{minus, kRootHalf * image}});
        }
    }
}

void LightLayout::add_runs(int m, std::size_t& even, std::size_t& odd, std::size_t& spin) {
    const auto add = [this](const Run& run) {
        if (run.count > 0) runs_.push_back(run);
    };
    const std::size_t evens = count_of(m, 2, order_);
    const std::size_t odds = count_of(m + 1, 2, order_);
    const auto add_scalars = [&](LightKind part, int l, std::size_t count, std::size_t cosine) {
        const std::size_t sine = m > 0 ? cosine + count : cosine;
        const bool s0 = part == LightKind::unpolarized;
        add({part, m, l, 2, count, s0 ? cosine : sine, s0 ? sine : cosine, s0 ? 1.0F : -1.0F});
    };
    add_scalars(LightKind::unpolarized, m, evens, even);
    add_scalars(LightKind::unpolarized, m + 1, odds, odd);
    if (kind_ != LightKind::unpolarized) {
        const std::size_t o = spin_.size();  // offset from a number of e to the number of o
        if (m == 0) {
            const std::size_t cosines = count_of(2, 2, order_);
            const std::size_t sines = count_of(3, 2, order_);
            add({LightKind::linear, 0, 2, 2, cosines, spin, spin + o, 1});
            add({LightKind::linear, 0, 3, 2, sines, spin + cosines + o, spin + cosines, -1});
            spin += cosines + sines;
        } else {
            const int l = std::max(m, 2);
            const std::size_t count = count_of(l, 1, order_);
            add({LightKind::linear, m, l, 1, count, spin, spin + count, 1});
            add({LightKind::linear, m, l, 1, count, spin + o + count, spin + o, -1});
            spin += 2 * count;
        }
    }
    if (kind_ == LightKind::full) {
        add_scalars(LightKind::full, m, evens, s3_begin() + even);
        add_scalars(LightKind::full, m + 1, odds, s3_begin() + odd);
    }
    even += (m > 0 ? 2 : 1) * evens;
    odd += (m > 0 ? 2 : 1) * odds;
}

void zenith_functions(const LightLayout& layout, std::span<const double> scalar,
                      std::span<const double> spin2, std::span<double> first, std::span<double> second) {
    std::size_t j = 0;
    for (const LightLayout::Run& run : layout.runs()) {
        for (std::size_t i = 0; i < run.count; ++i, ++j) {
            const int l = run.l + static_cast<int>(i) * run.step;
            if (run.part != LightKind::linear) {
                first[j] = (run.m > 0 ? std::numbers::sqrt2 : 1) * scalar[psh_index(l, run.m)];
                second[j] = 0;
            } else if (run.m == 0) {
                first[j] = spin2[psh_index(l, 0)];
                second[j] = -first[j];
            } else {
                const double plus = kRootHalf * spin2[psh_index(l, run.m)];
                const double minus = (l % 2 == 0 ? kRootHalf : -kRootHalf) * spin2[psh_index(l, -run.m)];
                first[j] = run.sign > 0 ? plus + minus : plus - minus;
                second[j] = run.sign > 0 ? plus - minus : plus + minus;
            }
        }
    }
}

}  // namespace nicol
