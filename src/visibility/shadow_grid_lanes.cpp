// SPDX-License-Identifier: MIT
#include "visibility/shadow_grid_lanes.hpp"

#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

using Component = ShadowGrid::Component;
using Pair = ShadowGrid::Pair;
using Slots = ShadowGrid::Slots;

// Legendre, coefficients to slots.
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

// And back, adding.
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

// The samples of Parts functions in Count columns from `table` on: what is loaded of one serves all of the
// other.
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

// And back, adding.
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

// Count columns of one row, from the first of visibility's samples there.
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

}  // namespace

void synthesize_row(const Component& component, const Slots& slots, std::size_t row, std::size_t quarter,
                    const Lanes* in, Lanes* samples) {
    LaneVector values[1][kMostSlots] = {};
    to_slots(component, row, in, values[0]);
    for (std::size_t column = 0; column < quarter; ++column) {
        LaneVector images[1][1][4];
        to_columns<1, 1>(slots, slots.table.data() + column * slots.begin[4], values, images);
        for (std::size_t image = 0; image < 4; ++image) {
            store(samples + 4 * column + image, images[0][0][image]);
        }
    }
}

void multiply_pair(const Pair& from, const Pair& to, const Slots& slots, std::size_t rows,
                   std::size_t quarter, const std::int16_t* samples, const Lanes* in, Lanes* out) {
    dispatch<multiply_rows>(from, to, slots, rows, quarter, samples, in, out);
}

}  // namespace nicol
