// SPDX-License-Identifier: MIT
// The recursion of the Legendre step over vectors of rings; part of vector_kernel_impl.hpp.
#pragma once

#include "harmonics/vectors.hpp"

namespace nicol {
namespace {

#if NICOL_LANES == 8
typedef double Half __attribute__((vector_size(32), aligned(8), may_alias));
#endif

/// Steps between two looks at the range: values grow by less than 2^7 a step.
constexpr int kStride = 8;
constexpr double kGrown = 0x1p100;
constexpr double kDown = 0x1p-256;

/// N vectors of rings on their way up the recursion.
template <int N>
struct State {
    Vector t[N] = {}, y[N] = {}, before[N] = {}, factor[N] = {};
    int exponent[N * kLanes] = {};
    bool settled = true;  ///< every factor is 1
    bool any = false;     ///< some factor is not 0

    void load(const LegendreRings& r, int first) {
        for (int v = 0; v < N; ++v) {
            t[v] = at(r.t + first + v * kLanes);
            y[v] = at(r.value + first + v * kLanes);
            before[v] = Vector{};
        }
        for (int i = 0; i < N * kLanes; ++i)
            exponent[i] = y[i / kLanes][i % kLanes] == 0 ? 0 : r.exponent[first + i];
        update();
    }

    void update() {
        settled = true;
        any = false;
        for (int i = 0; i < N * kLanes; ++i) {
            factor[i / kLanes][i % kLanes] = exponent[i] == 0 ? 1.0 : exponent[i] == -1 ? kDown : 0.0;
            settled = settled && exponent[i] == 0;
            any = any || exponent[i] >= -1;
        }
    }

    inline __attribute__((always_inline)) void advance(const LegendreStep& s) {
        for (int v = 0; v < N; ++v) {
            const Vector next = (s.p - s.q * t[v]) * y[v] - s.c * before[v];
            before[v] = y[v];
            y[v] = next;
        }
    }

    void rescale() {
        Mask grown{};
        for (int v = 0; v < N; ++v) grown |= (y[v] > kGrown) | (y[v] < -kGrown);
        long long any_grown = 0;
        for (int i = 0; i < kLanes; ++i) any_grown |= grown[i];
        if (any_grown == 0) return;
        for (int i = 0; i < N * kLanes; ++i) {
            const double value = y[i / kLanes][i % kLanes];
            if (exponent[i] < 0 && (value > kGrown || value < -kGrown)) {
                y[i / kLanes][i % kLanes] *= kDown;
                before[i / kLanes][i % kLanes] *= kDown;
                ++exponent[i];
            }
        }
        update();
    }
};

template <int N, bool Split>
void synthesize_rings(const LegendreStep* steps, int count, const LegendreRings& rings, int first,
                      double* out, long stride) {
    State<N> state;
    state.load(rings, first);
    Vector even[4][N] = {};
    Vector odd[Split ? 4 : 1][Split ? N : 1] = {};
    const auto add_even = [&](const LegendreStep& s, const Vector* y) {
        for (int k = 0; k < 4; ++k)
            for (int v = 0; v < N; ++v) even[k][v] += s.f[k] * y[v];
    };
    const auto add_odd = [&](const LegendreStep& s, const Vector* y) {
        if constexpr (Split) {
            for (int k = 0; k < 4; ++k)
                for (int v = 0; v < N; ++v) odd[k][v] += s.f[k] * y[v];
        } else {
            add_even(s, y);
        }
    };
    int i = 0;
    while (!state.settled && i < count) {
        const int end = i + kStride < count ? i + kStride : count;
        if (state.any) {
            for (; i < end; ++i) {
                Vector y[N];
                for (int v = 0; v < N; ++v) y[v] = state.y[v] * state.factor[v];
                if (i % 2 == 0)
                    add_even(steps[i], y);
                else
                    add_odd(steps[i], y);
                state.advance(steps[i]);
            }
        } else {
            for (; i < end; ++i) state.advance(steps[i]);
        }
        state.rescale();
    }
    Vector t[N], y[N], z[N];  // z: the order before y
    for (int v = 0; v < N; ++v) {
        t[v] = state.t[v];
        y[v] = state.y[v];
        z[v] = state.before[v];
    }
    for (; i + 2 <= count; i += 2) {
        const LegendreStep& a = steps[i];
        const LegendreStep& b = steps[i + 1];
        add_even(a, y);
        for (int v = 0; v < N; ++v) z[v] = (a.p - a.q * t[v]) * y[v] - a.c * z[v];
        add_odd(b, z);
        for (int v = 0; v < N; ++v) y[v] = (b.p - b.q * t[v]) * z[v] - b.c * y[v];
    }
    if (i < count) add_even(steps[i], y);
    for (int k = 0; k < 4; ++k)
        for (int v = 0; v < N; ++v) {
            at(out + k * stride + first + v * kLanes) = even[k][v];
            if constexpr (Split) at(out + (4 + k) * stride + first + v * kLanes) = odd[k][v];
        }
}

/// Lane k of the result is the sum of the lanes of v[k], for kLanes vectors.
inline __attribute__((always_inline)) Vector sums_of_lanes(const Vector* v) {
#if NICOL_LANES == 2
    return __builtin_shufflevector(v[0], v[1], 0, 2) + __builtin_shufflevector(v[0], v[1], 1, 3);
#elif NICOL_LANES == 4
    Vector pair[2];
    for (int i = 0; i < 2; ++i)
        pair[i] = __builtin_shufflevector(v[2 * i], v[2 * i + 1], 0, 4, 2, 6) +
                  __builtin_shufflevector(v[2 * i], v[2 * i + 1], 1, 5, 3, 7);
    return __builtin_shufflevector(pair[0], pair[1], 0, 1, 4, 5) +
           __builtin_shufflevector(pair[0], pair[1], 2, 3, 6, 7);
#else
    Vector pair[4], four[2];
    for (int i = 0; i < 4; ++i)
        pair[i] = __builtin_shufflevector(v[2 * i], v[2 * i + 1], 0, 8, 2, 10, 4, 12, 6, 14) +
                  __builtin_shufflevector(v[2 * i], v[2 * i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    for (int i = 0; i < 2; ++i)
        four[i] = __builtin_shufflevector(pair[2 * i], pair[2 * i + 1], 0, 1, 4, 5, 8, 9, 12, 13) +
                  __builtin_shufflevector(pair[2 * i], pair[2 * i + 1], 2, 3, 6, 7, 10, 11, 14, 15);
    return __builtin_shufflevector(four[0], four[1], 0, 1, 4, 5, 8, 9, 12, 13) +
           __builtin_shufflevector(four[0], four[1], 2, 3, 6, 7, 10, 11, 14, 15);
#endif
}

/// Adds the sums of the lanes of dots[0..3] to step[0].f, of dots[4..7] to step[1].f.
inline __attribute__((always_inline)) void add_to_steps(const Vector* dots, LegendreStep* step) {
    for (int k = 0; k < 8; k += kLanes) {
        const Vector sums = sums_of_lanes(dots + k);
#if NICOL_LANES == 8
        Half* even = reinterpret_cast<Half*>(step[0].f);
        Half* odd = reinterpret_cast<Half*>(step[1].f);
        *even += __builtin_shufflevector(sums, sums, 0, 1, 2, 3);
        *odd += __builtin_shufflevector(sums, sums, 4, 5, 6, 7);
#else
        at(step[k / 4].f + k % 4) += sums;
#endif
    }
}

template <int N, bool Split>
void analyze_rings(LegendreStep* steps, int count, const LegendreRings& rings, int first, const double* in,
                   long stride) {
    State<N> state;
    state.load(rings, first);
    Vector even[4][N];
    Vector odd[Split ? 4 : 1][Split ? N : 1];
    for (int k = 0; k < 4; ++k)
        for (int v = 0; v < N; ++v) {
            even[k][v] = at(in + k * stride + first + v * kLanes);
            if constexpr (Split) odd[k][v] = at(in + (4 + k) * stride + first + v * kLanes);
        }
    const auto multiply_even = [&](const Vector* y, Vector* dots) {
        for (int k = 0; k < 4; ++k) {
            dots[k] = even[k][0] * y[0];
            for (int v = 1; v < N; ++v) dots[k] += even[k][v] * y[v];
        }
    };
    const auto multiply_odd = [&](const Vector* y, Vector* dots) {
        if constexpr (Split) {
            for (int k = 0; k < 4; ++k) {
                dots[k] = odd[k][0] * y[0];
                for (int v = 1; v < N; ++v) dots[k] += odd[k][v] * y[v];
            }
        } else {
            multiply_even(y, dots);
        }
    };
    const auto finish = [&](const Vector* y) {
        // No step follows that could share the sums.
        Vector dots[4];
        multiply_even(y, dots);
        for (int k = 0; k < 4; ++k)
            for (int lane = 0; lane < kLanes; ++lane) steps[count - 1].f[k] += dots[k][lane];
    };
    int i = 0;
    while (!state.settled && i < count) {
        const int end = i + kStride < count ? i + kStride : count;
        if (state.any) {
            Vector y[N], z[N], dots[8];
            for (; i + 2 <= end; i += 2) {
                for (int v = 0; v < N; ++v) y[v] = state.y[v] * state.factor[v];
                state.advance(steps[i]);
                for (int v = 0; v < N; ++v) z[v] = state.y[v] * state.factor[v];
                state.advance(steps[i + 1]);
                multiply_even(y, dots);
                multiply_odd(z, dots + 4);
                add_to_steps(dots, steps + i);
            }
            if (i < end) {
                for (int v = 0; v < N; ++v) y[v] = state.y[v] * state.factor[v];
                finish(y);
                ++i;
            }
        } else {
            for (; i < end; ++i) state.advance(steps[i]);
        }
        state.rescale();
    }
    Vector t[N], y[N], z[N], dots[8];
    for (int v = 0; v < N; ++v) {
        t[v] = state.t[v];
        y[v] = state.y[v];
        z[v] = state.before[v];
    }
    for (; i + 2 <= count; i += 2) {
        const LegendreStep& a = steps[i];
        const LegendreStep& b = steps[i + 1];
        multiply_even(y, dots);
        for (int v = 0; v < N; ++v) z[v] = (a.p - a.q * t[v]) * y[v] - a.c * z[v];
        multiply_odd(z, dots + 4);
        for (int v = 0; v < N; ++v) y[v] = (b.p - b.q * t[v]) * z[v] - b.c * y[v];
        add_to_steps(dots, steps + i);
    }
    if (i < count) finish(y);
}

/// Calls work.template operator()<N>(first) for all rings, N vectors at a time.
template <int Most>
inline void in_groups(int rings, auto&& work) {
    const int vectors = rings / kLanes;
    const int groups = (vectors + Most - 1) / Most;
    int done = 0;
    for (int g = 0; g < groups; ++g) {
        // Groups of even size: a last one of a single vector would wait for its own recursion.
        const int size = (vectors - done + groups - g - 1) / (groups - g);
        const int first = done * kLanes;
        if (size == 1) work.template operator()<1>(first);
        if (size == 2) work.template operator()<2>(first);
        if constexpr (Most >= 3)
            if (size == 3) work.template operator()<3>(first);
        if constexpr (Most >= 4)
            if (size == 4) work.template operator()<4>(first);
        done += size;
    }
}

template <bool Split>
void synthesize_all(const LegendreStep* steps, int count, const LegendreRings& rings, double* out,
                    long stride) {
    in_groups<Split ? NICOL_SPLIT_VECTORS : NICOL_VECTORS>(rings.rings, [&]<int N>(int first) {
        synthesize_rings<N, Split>(steps, count, rings, first, out, stride);
    });
}

void synthesize(const LegendreStep* steps, int count, const LegendreRings& rings, bool split, double* out,
                long stride) {
    if (split)
        synthesize_all<true>(steps, count, rings, out, stride);
    else
        synthesize_all<false>(steps, count, rings, out, stride);
}

template <bool Split>
void analyze_all(LegendreStep* steps, int count, const LegendreRings& rings, const double* in, long stride) {
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 4; ++k) steps[i].f[k] = 0;
    in_groups<Split ? NICOL_SPLIT_VECTORS : NICOL_VECTORS>(rings.rings, [&]<int N>(int first) {
        analyze_rings<N, Split>(steps, count, rings, first, in, stride);
    });
}

void analyze(LegendreStep* steps, int count, const LegendreRings& rings, bool split, const double* in,
             long stride) {
    if (split)
        analyze_all<true>(steps, count, rings, in, stride);
    else
        analyze_all<false>(steps, count, rings, in, stride);
}

}  // namespace
}  // namespace nicol
