// SPDX-License-Identifier: MIT
#include "visibility/shadow_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "harmonics/psh.hpp"
#include "visibility/shadow_grid_lanes.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

using Harmonic = LightLayout::Harmonic;

// Those of even l + m.
std::vector<Harmonic> mirrored_harmonics(int order) {
    std::vector<Harmonic> out;
    for (int m = -order; m <= order; ++m) {
        for (int l = std::abs(m); l <= order; l += 2) out.push_back({l, m});
    }
    return out;
}

ShadowGrid::Component component(const std::vector<SeparatedHarmonic>& harmonics, bool second, double factor,
                                const UpperRows& rows, bool weighted, std::size_t quarter,
                                const ShadowGrid::Slots& slots, std::size_t begin) {
    ShadowGrid::Component out;
    out.begin = begin;
    out.harmonics = harmonics.size();
    for (std::uint32_t h = 0; h < harmonics.size(); ++h) {
        const int m = harmonics[h].m;
        const std::uint32_t slot = slots.of(second ? other_trigonometric(m) : m);
        if (out.runs.empty() || out.runs.back().slot != slot) out.runs.push_back({h, h, slot});
        ++out.runs.back().last;
    }
    for (std::size_t row = 0; row < rows.count(); ++row) {
        const double solid_angle =
            weighted ? rows.weight(row) * 2 * pi / (4 * static_cast<double>(quarter)) : 1.0;
        for (const SeparatedHarmonic& h : harmonics) {
            out.on_rows.push_back(
                static_cast<float>(factor * solid_angle * (second ? h.second : h.first)[row]));
        }
    }
    return out;
}

}  // namespace

ShadowGrid::Slots::Slots(int order, std::size_t quarter) {
    const auto count = static_cast<std::uint32_t>(order);
    begin = {0, count / 2 + 1, count + 1, count + 1 + count / 2, 2 * count + 1};
    table.resize(quarter * begin[4]);
    for (std::size_t column = 0; column < quarter; ++column) {
        const double phi = 2 * pi * (static_cast<double>(column) + 0.5) / (4 * static_cast<double>(quarter));
        for (int m = -order; m <= order; ++m) {
            table[column * begin[4] + of(m)] =
                static_cast<float>(m < 0 ? std::sin(-m * phi) : std::cos(m * phi));
        }
    }
}

std::uint32_t ShadowGrid::Slots::of(int m) const {
    const auto degree = static_cast<std::uint32_t>(std::abs(m));
    if (m >= 0) return begin[degree % 2] + degree / 2;
    return degree % 2 == 0 ? begin[2] + degree / 2 - 1 : begin[3] + degree / 2;
}

// The integrand has degree 4 order: rows integrate polynomials below twice their count, columns degrees below
// theirs.
ShadowGrid::ShadowGrid(const LightLayout& layout)
    : rows_(2 * layout.order() + 1),
      quarter_(static_cast<std::size_t>(layout.order()) + 1),
      slots_(layout.order(), quarter_),
      slots_visibility_(2 * layout.order(), quarter_) {
    add_pairs(layout, false, pairs_in_);
    add_pairs(layout, true, pairs_out_);
    const std::vector<Harmonic> harmonics = mirrored_harmonics(2 * layout.order());
    visibility_ =
        component(separate_scalars(harmonics, rows_), false, 1, rows_, false, quarter_, slots_visibility_, 0);
    for (const Harmonic& h : harmonics) visibility_index_.push_back(psh_index(h.l, h.m));
}

// The light's s0, s1, s2 and s3. With e and i o for even and odd parts of s1 + i s2, the even part of s1 is
// that of e and its odd part minus the s2 of o, and so on.
void ShadowGrid::add_pairs(const LightLayout& layout, bool weighted, std::vector<Pair>& pairs) const {
    const std::vector<SeparatedHarmonic> even = separate_scalars(layout.even(), rows_);
    const std::vector<SeparatedHarmonic> odd = separate_scalars(layout.odd(), rows_);
    const auto make = [&](const std::vector<SeparatedHarmonic>& harmonics, bool second, double factor,
                          std::size_t begin) {
        return component(harmonics, second, factor, rows_, weighted, quarter_, slots_, begin);
    };
    const auto add_scalar = [&](std::size_t begin) {
        pairs.push_back({make(even, false, 1, begin), make(odd, false, 1, begin + even.size())});
    };
    add_scalar(0);
    if (layout.kind() == LightKind::unpolarized) return;
    const std::vector<SeparatedHarmonic> spin = separate_spins(layout.spin(), rows_);
    const std::size_t e = layout.spin_begin();
    const std::size_t o = e + spin.size();
    pairs.push_back({make(spin, false, 1, e), make(spin, true, -1, o)});
    pairs.push_back({make(spin, true, 1, e), make(spin, false, 1, o)});
    if (layout.kind() == LightKind::full) add_scalar(layout.s3_begin());
}

void ShadowGrid::sample(const Lanes* visibility, Lanes* samples) const {
    std::vector<Lanes> coefficients;
    for (const std::size_t index : visibility_index_) coefficients.push_back(visibility[index]);
    for (std::size_t row = 0; row < rows_.count(); ++row) {
        synthesize_row(visibility_, slots_visibility_, row, quarter_, coefficients.data(),
                       samples + 4 * quarter_ * row);
    }
}

void ShadowGrid::multiply(const std::int16_t* samples, const Lanes* in, Lanes* out) const {
    for (std::size_t p = 0; p < pairs_in_.size(); ++p) {
        for (const Component& part : pairs_out_[p]) std::fill_n(out + part.begin, part.harmonics, Lanes{});
    }
    for (std::size_t p = 0; p < pairs_in_.size(); ++p) {
        multiply_pair(pairs_in_[p], pairs_out_[p], slots_, rows_.count(), quarter_, samples, in, out);
    }
}

}  // namespace nicol
