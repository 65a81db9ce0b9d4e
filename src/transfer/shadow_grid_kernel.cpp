// SPDX-License-Identifier: MIT
#include "transfer/shadow_grid_kernel.hpp"

#include "transfer/lane_vector.hpp"
#include "transfer/simd.hpp"

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

[[gnu::always_inline]] inline void to_columns(const Slots& layout, const float* table,
                                              const LaneVector* slots, LaneVector* columns) {
    LaneVector sum[4];
    for (std::size_t k = 0; k < 4; ++k) {
        LaneVector s{};
        for (std::uint32_t slot = layout.begin[k]; slot < layout.begin[k + 1]; ++slot) {
            s += table[slot] * slots[slot];
        }
        sum[k] = s;
    }
    const LaneVector a = sum[0] + sum[1];
    const LaneVector b = sum[0] - sum[1];
    const LaneVector c = sum[2] + sum[3];
    const LaneVector d = sum[3] - sum[2];
    columns[0] = a + c;
    columns[1] = a - c;
    columns[2] = b + d;
    columns[3] = b - d;
}

[[gnu::always_inline]] inline void from_columns(const Slots& layout, const float* table,
                                                const LaneVector* columns, LaneVector* slots) {
    const LaneVector a = columns[0] + columns[1];
    const LaneVector b = columns[2] + columns[3];
    const LaneVector c = columns[0] - columns[1];
    const LaneVector d = columns[2] - columns[3];
    const LaneVector sum[4] = {a + b, a - b, c - d, c + d};
    for (std::size_t k = 0; k < 4; ++k) {
        const LaneVector s = sum[k];
        for (std::uint32_t slot = layout.begin[k]; slot < layout.begin[k + 1]; ++slot) {
            slots[slot] += table[slot] * s;
        }
    }
}

template <bool Dark, class Number>
[[gnu::always_inline]] inline void multiply_rows(const Pair& from, const Slots& slots_in, const Pair& to,
                                                 const Slots& slots_out, std::size_t rows,
                                                 std::size_t quarter, const Number* even, const Number* odd,
                                                 const Lanes* in, Lanes* out) {
    constexpr float one = sizeof(Number) == sizeof(float) ? 1.0F : kFixedOne;
    LaneVector before[2][kMostSlots];
    LaneVector after[2][kMostSlots];
    for (std::size_t part = 0; part < 2; ++part) {
        for (std::uint32_t s = 0; s < slots_in.begin[4]; ++s) before[part][s] = LaneVector{};
    }
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t part = 0; part < 2; ++part) {
            to_slots(from[part], row, in + from[part].begin, before[part]);
            for (std::uint32_t s = 0; s < slots_out.begin[4]; ++s) after[part][s] = LaneVector{};
        }
        for (std::size_t column = 0; column < quarter; ++column) {
            const float* table_in = slots_in.table.data() + column * slots_in.begin[4];
            const float* table_out = slots_out.table.data() + column * slots_out.begin[4];
            LaneVector f[2][4];
            for (std::size_t part = 0; part < 2; ++part) {
                to_columns(slots_in, table_in, before[part], f[part]);
            }
            const std::size_t sample = 4 * (row * quarter + column) * kLanes;
            for (std::size_t image = 0; image < 4; ++image) {
                LaneVector v;
                load(even + sample + image * kLanes, v);
                v *= 1 / one;
                if constexpr (Dark) {
                    LaneVector w;
                    load(odd + sample + image * kLanes, w);
                    w *= 1 / one;
                    const LaneVector mixed = v * f[0][image] + w * f[1][image];
                    f[1][image] = v * f[1][image] + w * f[0][image];
                    f[0][image] = mixed;
                } else {
                    f[0][image] *= v;
                    f[1][image] *= v;
                }
            }
            for (std::size_t part = 0; part < 2; ++part) {
                from_columns(slots_out, table_out, f[part], after[part]);
            }
        }
        for (std::size_t part = 0; part < 2; ++part) {
            from_slots(to[part], row, after[part], out + to[part].begin);
        }
    }
}

NICOL_MULTIVERSION
void multiply_floats(const Pair& from, const Slots& slots_in, const Pair& to, const Slots& slots_out,
                     std::size_t rows, std::size_t quarter, const float* even, const float* odd,
                     const Lanes* in, Lanes* out) {
    if (odd != nullptr) {
        multiply_rows<true>(from, slots_in, to, slots_out, rows, quarter, even, odd, in, out);
    } else {
        multiply_rows<false>(from, slots_in, to, slots_out, rows, quarter, even, odd, in, out);
    }
}

NICOL_MULTIVERSION
void multiply_fixed(const Pair& from, const Slots& slots_in, const Pair& to, const Slots& slots_out,
                    std::size_t rows, std::size_t quarter, const std::int16_t* even, const std::int16_t* odd,
                    const Lanes* in, Lanes* out) {
    if (odd != nullptr) {
        multiply_rows<true>(from, slots_in, to, slots_out, rows, quarter, even, odd, in, out);
    } else {
        multiply_rows<false>(from, slots_in, to, slots_out, rows, quarter, even, odd, in, out);
    }
}

}  // namespace

void synthesize_row(const Component& component, const Slots& slots, std::size_t row, std::size_t quarter,
                    const Lanes* in, Lanes* samples) {
    LaneVector values[kMostSlots] = {};
    to_slots(component, row, in, values);
    for (std::size_t column = 0; column < quarter; ++column) {
        LaneVector images[4];
        to_columns(slots, slots.table.data() + column * slots.begin[4], values, images);
        for (std::size_t image = 0; image < 4; ++image) store(samples + 4 * column + image, images[image]);
    }
}

void multiply_pair(const Pair& from, const Slots& slots_in, const Pair& to, const Slots& slots_out,
                   std::size_t rows, std::size_t quarter, const float* even, const float* odd,
                   const Lanes* in, Lanes* out) {
    multiply_floats(from, slots_in, to, slots_out, rows, quarter, even, odd, in, out);
}

void multiply_pair(const Pair& from, const Slots& slots_in, const Pair& to, const Slots& slots_out,
                   std::size_t rows, std::size_t quarter, const std::int16_t* even, const std::int16_t* odd,
                   const Lanes* in, Lanes* out) {
    multiply_fixed(from, slots_in, to, slots_out, rows, quarter, even, odd, in, out);
}

}  // namespace nicol
