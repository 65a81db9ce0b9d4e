// SPDX-License-Identifier: MIT
#include "visibility/shadow_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "harmonics/psh.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"
#include "simd/lanes.hpp"
#include "simd/zero_lanes.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

using Harmonic = LightLayout::Harmonic;
using Component = ShadowGrid::Component;
using Pair = ShadowGrid::Pair;
using Slots = ShadowGrid::Slots;

/// Largest number of slots of one component: 2 order + 1 for order 64.
constexpr std::size_t kMostSlots = 2 * 64 + 1;

// Returns the harmonics of even l + m.
std::vector<Harmonic> mirrored_harmonics(int order) {
    std::vector<Harmonic> out;
    for (int m = -order; m <= order; ++m) {
        for (int l = std::abs(m); l <= order; l += 2) out.push_back({l, m});
    }
    return out;
}

Component component(const std::vector<SeparatedHarmonic>& harmonics, bool second, double factor,
                    const UpperRows& rows, bool weighted, std::size_t quarter, const Slots& slots,
                    std::size_t begin) {
    Component out;
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

// Computes the slots of one row from coefficients (Legendre transform).
[[gnu::always_inline]] inline void to_slots(const Component& component, std::size_t row, const Lanes* in,
                                            LaneVector* slots) {
    const float* harmonic = component.on_rows.data() + row * component.harmonics;
    for (const ShadowGrid::Run& run : component.runs) {
        LaneVector sum{};
        for (std::uint32_t h = run.first; h < run.last; ++h) {
            LaneVector x;
            load(in + h, x);
            sum += harmonic[h] * x;
        }
        slots[run.slot] = sum;
    }
}

// Adds the coefficients of one row's slots to `out` (transposed Legendre transform).
[[gnu::always_inline]] inline void from_slots(const Component& component, std::size_t row,
                                              const LaneVector* slots, Lanes* out) {
    const float* harmonic = component.on_rows.data() + row * component.harmonics;
    for (const ShadowGrid::Run& run : component.runs) {
        const LaneVector slot = slots[run.slot];
        for (std::uint32_t h = run.first; h < run.last; ++h) {
            LaneVector x;
            load(out + h, x);
            store(out + h, x + harmonic[h] * slot);
        }
    }
}

// Computes the samples of Parts functions in Count columns, whose factors begin at `table`. Each loaded
// factor serves all functions, and each loaded slot all columns.
template <std::size_t Parts, std::size_t Count>
[[gnu::always_inline]] inline void to_columns(const Slots& layout, const float* table,
                                              const LaneVector (*slots)[kMostSlots],
                                              LaneVector (&samples)[Parts][Count][4]) {
    const std::size_t stride = layout.begin[4];
    LaneVector sum[4][Parts][Count];
    for (std::size_t k = 0; k < 4; ++k) {
        LaneVector total[Parts][Count] = {};
        for (std::uint32_t slot = layout.begin[k]; slot < layout.begin[k + 1]; ++slot) {
            for (std::size_t p = 0; p < Parts; ++p) {
                const LaneVector x = slots[p][slot];
                for (std::size_t c = 0; c < Count; ++c) total[p][c] += table[c * stride + slot] * x;
            }
        }
        for (std::size_t p = 0; p < Parts; ++p) {
            for (std::size_t c = 0; c < Count; ++c) sum[k][p][c] = total[p][c];
        }
    }
    for (std::size_t p = 0; p < Parts; ++p) {
        for (std::size_t c = 0; c < Count; ++c) {
            const LaneVector even = sum[0][p][c] + sum[1][p][c];
            const LaneVector odd = sum[0][p][c] - sum[1][p][c];
            const LaneVector right = sum[2][p][c] + sum[3][p][c];
            const LaneVector left = sum[3][p][c] - sum[2][p][c];
            samples[p][c][0] = even + right;
            samples[p][c][1] = even - right;
            samples[p][c][2] = odd + left;
            samples[p][c][3] = odd - left;
        }
    }
}

// Adds the samples to the slots: the adjoint of to_columns().
template <std::size_t Parts, std::size_t Count>
[[gnu::always_inline]] inline void from_columns(const Slots& layout, const float* table,
                                                const LaneVector (&samples)[Parts][Count][4],
                                                LaneVector (*slots)[kMostSlots]) {
    const std::size_t stride = layout.begin[4];
    LaneVector sum[4][Parts][Count];
    for (std::size_t p = 0; p < Parts; ++p) {
        for (std::size_t c = 0; c < Count; ++c) {
            const LaneVector* f = samples[p][c];
            const LaneVector right = f[0] + f[1];
            const LaneVector left = f[2] + f[3];
            const LaneVector up = f[0] - f[1];
            const LaneVector down = f[2] - f[3];
            sum[0][p][c] = right + left;
            sum[1][p][c] = right - left;
            sum[2][p][c] = up - down;
            sum[3][p][c] = up + down;
        }
    }
    for (std::size_t k = 0; k < 4; ++k) {
        for (std::uint32_t slot = layout.begin[k]; slot < layout.begin[k + 1]; ++slot) {
            for (std::size_t p = 0; p < Parts; ++p) {
                LaneVector x = slots[p][slot];
                for (std::size_t c = 0; c < Count; ++c) x += table[c * stride + slot] * sum[k][p][c];
                slots[p][slot] = x;
            }
        }
    }
}

// Multiplies Count columns of one row by visibility; `samples` are those of visibility from the first column
// on.
template <std::size_t Count>
[[gnu::always_inline]] inline void multiply_columns(const Slots& slots, const float* table,
                                                    const LaneVector (*before)[kMostSlots],
                                                    LaneVector (*after)[kMostSlots],
                                                    const std::int16_t* samples) {
    LaneVector f[2][Count][4];
    to_columns<2, Count>(slots, table, before, f);
    for (std::size_t c = 0; c < Count; ++c) {
        for (std::size_t image = 0; image < 4; ++image) {
            LaneVector v;
            load(samples + (4 * c + image) * kLanes, v);
            v *= 1 / kFixedOne;
            f[0][c][image] *= v;
            f[1][c][image] *= v;
        }
    }
    from_columns<2, Count>(slots, table, f, after);
}

[[gnu::always_inline]] inline void multiply_rows(const Pair& from, const Pair& to, const Slots& slots,
                                                 std::size_t rows, std::size_t quarter,
                                                 const std::int16_t* samples, const Lanes* in, Lanes* out) {
    LaneVector before[2][kMostSlots];
    LaneVector after[2][kMostSlots];
    for (auto& part : before) {
        for (std::uint32_t s = 0; s < slots.begin[4]; ++s) part[s] = LaneVector{};
    }
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t part = 0; part < 2; ++part) {
            to_slots(from[part], row, in + from[part].begin, before[part]);
            for (std::uint32_t s = 0; s < slots.begin[4]; ++s) after[part][s] = LaneVector{};
        }
        for (std::size_t column = 0; column < quarter;) {
            const float* table = slots.table.data() + column * slots.begin[4];
            const std::int16_t* here = samples + 4 * (row * quarter + column) * kLanes;
            if (quarter - column >= 3) {
                multiply_columns<3>(slots, table, before, after, here);
                column += 3;
            } else if (quarter - column == 2) {
                multiply_columns<2>(slots, table, before, after, here);
                column += 2;
            } else {
                multiply_columns<1>(slots, table, before, after, here);
                column += 1;
            }
        }
        for (std::size_t part = 0; part < 2; ++part) {
            from_slots(to[part], row, after[part], out + to[part].begin);
        }
    }
}

/// Computes samples[4 column + image] in Count columns of one row.
template <std::size_t Count>
[[gnu::always_inline]] inline void synthesize_columns(const Slots& slots, const float* table,
                                                      const LaneVector (*values)[kMostSlots],
                                                      Lanes* samples) {
    LaneVector images[1][Count][4];
    to_columns<1, Count>(slots, table, values, images);
    for (std::size_t c = 0; c < Count; ++c)
        for (std::size_t image = 0; image < 4; ++image) store(samples + 4 * c + image, images[0][c][image]);
}

/// Computes samples of all rows, of a component with coefficients `in`: [row][4 column + image].
[[gnu::always_inline]] inline void synthesize_rows(const Component& component, const Slots& slots,
                                                   std::size_t rows, std::size_t quarter, const Lanes* in,
                                                   Lanes* samples) {
    LaneVector values[1][kMostSlots];
    for (std::uint32_t s = 0; s < slots.begin[4]; ++s) values[0][s] = LaneVector{};
    for (std::size_t row = 0; row < rows; ++row) {
        to_slots(component, row, in, values[0]);
        std::size_t column = 0;
        for (; column + 4 <= quarter; column += 4)
            synthesize_columns<4>(slots, slots.table.data() + column * slots.begin[4], values,
                                  samples + 4 * (row * quarter + column));
        for (; column < quarter; ++column)
            synthesize_columns<1>(slots, slots.table.data() + column * slots.begin[4], values,
                                  samples + 4 * (row * quarter + column));
    }
}

/// Adds to the pair `to` of the light `out`: visibility times the pair `from` of the light `in`.
void multiply_pair(const Pair& from, const Pair& to, const Slots& slots, std::size_t rows,
                   std::size_t quarter, const std::int16_t* samples, const Lanes* in, Lanes* out) {
    dispatch<multiply_rows>(from, to, slots, rows, quarter, samples, in, out);
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

// The integrand has degree 4 order: Gauss-Legendre rows integrate polynomials below twice their count,
// columns integrate degrees below their count.
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

// Adds pairs for the light's s0, s1, s2 and s3. Let e and i o be the even and odd parts of s1 + i s2. Then
// the even part of s1 is the s1 of e and its odd part is minus the s2 of o; the even part of s2 is the s2 of
// e and its odd part is the s1 of o.
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
    dispatch<synthesize_rows>(visibility_, slots_visibility_, rows_.count(), quarter_,
                              static_cast<const Lanes*>(coefficients.data()), samples);
}

void ShadowGrid::multiply(const std::int16_t* samples, const Lanes* in, Lanes* out) const {
    for (std::size_t p = 0; p < pairs_in_.size(); ++p) {
        for (const Component& part : pairs_out_[p]) std::fill_n(out + part.begin, part.harmonics, Lanes{});
    }
    for (std::size_t p = 0; p < pairs_in_.size(); ++p) {
        // Unpolarized light has zeros where its bounces are polarized.
        if (std::ranges::all_of(pairs_in_[p], [in](const Component& part) {
                return all_zero(std::span(in + part.begin, part.harmonics));
            }))
            continue;
        multiply_pair(pairs_in_[p], pairs_out_[p], slots_, rows_.count(), quarter_, samples, in, out);
    }
}

}  // namespace nicol
