// SPDX-License-Identifier: MIT
#include "harmonics/legendre_recurrence.hpp"

#include "harmonics/scaled.hpp"
#include "simd/dispatch.hpp"
#include "simd/double_vectors.hpp"

namespace nicol {
namespace {

// Steps between two checks of the range, because values grow by less than 2^7 per step.
constexpr int kCheckedSteps = 8;
constexpr double kLargest = 0x1p100;

// State of the recurrence on N vectors of Width rings.
template <int Width, int N>
struct State {
    using Vector = typename DoubleVectors<Width>::Vector;

    Vector t[N] = {}, y[N] = {}, before[N] = {}, factor[N] = {};
    int exponent[N * Width] = {};
    bool settled = true;  ///< every factor is 1
    bool any = false;     ///< some factor is not 0

    [[gnu::always_inline]] inline void load(const LegendreRings& r, int first) {
        for (int v = 0; v < N; ++v) {
            load_vector(r.t + first + v * Width, t[v]);
            load_vector(r.value + first + v * Width, y[v]);
            before[v] = Vector{};
        }
        for (int i = 0; i < N * Width; ++i)
            exponent[i] = y[i / Width][i % Width] == 0 ? 0 : r.exponent[first + i];
        update();
    }

    [[gnu::always_inline]] inline void update() {
        settled = true;
        any = false;
        for (int i = 0; i < N * Width; ++i) {
            factor[i / Width][i % Width] = exponent[i] == 0 ? 1.0 : exponent[i] == -1 ? kScaleDown : 0.0;
            settled = settled && exponent[i] == 0;
            any = any || exponent[i] >= -1;
        }
    }

    [[gnu::always_inline]] inline void advance(const LegendreStep& s) {
        for (int v = 0; v < N; ++v) {
            const Vector next = (s.p - s.q * t[v]) * y[v] - s.c * before[v];
            before[v] = y[v];
            y[v] = next;
        }
    }

    [[gnu::always_inline]] inline void rescale() {
        typename DoubleVectors<Width>::Mask grown{};
        for (int v = 0; v < N; ++v) grown |= (y[v] > kLargest) | (y[v] < -kLargest);
        long long any_grown = 0;
        for (int i = 0; i < Width; ++i) any_grown |= grown[i];
        if (any_grown == 0) return;
        for (int i = 0; i < N * Width; ++i) {
            const double value = y[i / Width][i % Width];
            if (exponent[i] < 0 && (value > kLargest || value < -kLargest)) {
                y[i / Width][i % Width] *= kScaleDown;
                before[i / Width][i % Width] *= kScaleDown;
                ++exponent[i];
            }
        }
        update();
    }
};

template <int Width, int N, bool Split>
[[gnu::always_inline]] inline void synthesize_rings(const LegendreStep* steps, int count,
                                                    const LegendreRings& rings, int first, double* out,
                                                    long stride) {
    using Vector = typename DoubleVectors<Width>::Vector;
    State<Width, N> state;
    state.load(rings, first);
    Vector even[4][N] = {};
    Vector odd[Split ? 4 : 1][Split ? N : 1] = {};
    const auto add_even = [&](const LegendreStep& s, const Vector* y) __attribute__((always_inline)) {
        for (int k = 0; k < 4; ++k)
            for (int v = 0; v < N; ++v) even[k][v] += s.f[k] * y[v];
    };
    const auto add_odd = [&](const LegendreStep& s, const Vector* y) __attribute__((always_inline)) {
        if constexpr (Split) {
            for (int k = 0; k < 4; ++k)
                for (int v = 0; v < N; ++v) odd[k][v] += s.f[k] * y[v];
        } else {
            add_even(s, y);
        }
    };
    int i = 0;
    while (!state.settled && i < count) {
        const int end = i + kCheckedSteps < count ? i + kCheckedSteps : count;
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
    Vector t[N], y[N], z[N];  // z: y of the order before
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
            store_vector(out + k * stride + first + v * Width, even[k][v]);
            if constexpr (Split) store_vector(out + (4 + k) * stride + first + v * Width, odd[k][v]);
        }
}

// Sets lane k of `sums` to the sum of the lanes of v[k], for Width vectors.
template <int Width, class Vector>
[[gnu::always_inline]] inline void sum_lanes(const Vector* v, Vector& sums) {
    if constexpr (Width == 2) {
        sums = __builtin_shufflevector(v[0], v[1], 0, 2) + __builtin_shufflevector(v[0], v[1], 1, 3);
    } else if constexpr (Width == 4) {
        Vector pair[2];
        for (int i = 0; i < 2; ++i)
            pair[i] = __builtin_shufflevector(v[2 * i], v[2 * i + 1], 0, 4, 2, 6) +
                      __builtin_shufflevector(v[2 * i], v[2 * i + 1], 1, 5, 3, 7);
        sums = __builtin_shufflevector(pair[0], pair[1], 0, 1, 4, 5) +
               __builtin_shufflevector(pair[0], pair[1], 2, 3, 6, 7);
    } else {
        Vector pair[4], four[2];
        for (int i = 0; i < 4; ++i)
            pair[i] = __builtin_shufflevector(v[2 * i], v[2 * i + 1], 0, 8, 2, 10, 4, 12, 6, 14) +
                      __builtin_shufflevector(v[2 * i], v[2 * i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
        for (int i = 0; i < 2; ++i)
            four[i] = __builtin_shufflevector(pair[2 * i], pair[2 * i + 1], 0, 1, 4, 5, 8, 9, 12, 13) +
                      __builtin_shufflevector(pair[2 * i], pair[2 * i + 1], 2, 3, 6, 7, 10, 11, 14, 15);
        sums = __builtin_shufflevector(four[0], four[1], 0, 1, 4, 5, 8, 9, 12, 13) +
               __builtin_shufflevector(four[0], four[1], 2, 3, 6, 7, 10, 11, 14, 15);
    }
}

// Adds the sums of the lanes of dots[0..3] to step[0].f, and of dots[4..7] to step[1].f.
template <int Width, class Vector>
[[gnu::always_inline]] inline void add_to_steps(const Vector* dots, LegendreStep* step) {
    for (int k = 0; k < 8; k += Width) {
        Vector sums;
        sum_lanes<Width>(dots + k, sums);
        if constexpr (Width == 8) {
            add_vector(step[0].f, __builtin_shufflevector(sums, sums, 0, 1, 2, 3));
            add_vector(step[1].f, __builtin_shufflevector(sums, sums, 4, 5, 6, 7));
        } else {
            add_vector(step[k / 4].f + k % 4, sums);
        }
    }
}

template <int Width, int N, bool Split>
[[gnu::always_inline]] inline void analyze_rings(LegendreStep* steps, int count, const LegendreRings& rings,
                                                 int first, const double* in, long stride) {
    using Vector = typename DoubleVectors<Width>::Vector;
    State<Width, N> state;
    state.load(rings, first);
    Vector even[4][N];
    Vector odd[Split ? 4 : 1][Split ? N : 1];
    for (int k = 0; k < 4; ++k)
        for (int v = 0; v < N; ++v) {
            load_vector(in + k * stride + first + v * Width, even[k][v]);
            if constexpr (Split) load_vector(in + (4 + k) * stride + first + v * Width, odd[k][v]);
        }
    const auto multiply_even = [&](const Vector* y, Vector* dots) __attribute__((always_inline)) {
        for (int k = 0; k < 4; ++k) {
            dots[k] = even[k][0] * y[0];
            for (int v = 1; v < N; ++v) dots[k] += even[k][v] * y[v];
        }
    };
    const auto multiply_odd = [&](const Vector* y, Vector* dots) __attribute__((always_inline)) {
        if constexpr (Split) {
            for (int k = 0; k < 4; ++k) {
                dots[k] = odd[k][0] * y[0];
                for (int v = 1; v < N; ++v) dots[k] += odd[k][v] * y[v];
            }
        } else {
            multiply_even(y, dots);
        }
    };
    const auto finish = [&](const Vector* y) __attribute__((always_inline)) {
        // No step follows that could share the sums.
        Vector dots[4];
        multiply_even(y, dots);
        for (int k = 0; k < 4; ++k)
            for (int lane = 0; lane < Width; ++lane) steps[count - 1].f[k] += dots[k][lane];
    };
    int i = 0;
    while (!state.settled && i < count) {
        const int end = i + kCheckedSteps < count ? i + kCheckedSteps : count;
        if (state.any) {
            Vector y[N], z[N], dots[8];
            for (; i + 2 <= end; i += 2) {
                for (int v = 0; v < N; ++v) y[v] = state.y[v] * state.factor[v];
                state.advance(steps[i]);
                for (int v = 0; v < N; ++v) z[v] = state.y[v] * state.factor[v];
                state.advance(steps[i + 1]);
                multiply_even(y, dots);
                multiply_odd(z, dots + 4);
                add_to_steps<Width>(dots, steps + i);
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
        add_to_steps<Width>(dots, steps + i);
    }
    if (i < count) finish(y);
}

// Calls work.template operator()<N>(first) for all rings, N vectors at a time and at most Most.
template <int Width, int Most>
[[gnu::always_inline]] inline void in_groups(int rings, auto&& work) {
    const int vectors = rings / Width;
    const int groups = (vectors + Most - 1) / Most;
    int done = 0;
    for (int g = 0; g < groups; ++g) {
        // Groups are almost equal in size, because a last group of a single vector would wait for its own
        // recurrence.
        const int size = (vectors - done + groups - g - 1) / (groups - g);
        const int first = done * Width;
        if (size == 1) work.template operator()<1>(first);
        if (size == 2) work.template operator()<2>(first);
        if constexpr (Most >= 3)
            if (size == 3) work.template operator()<3>(first);
        if constexpr (Most >= 4)
            if (size == 4) work.template operator()<4>(first);
        done += size;
    }
}

// Runs synthesize_rings() on all rings. Most: vectors that fit into registers beside the sums. Split sums are
// twice as many.
template <int Width, int Most, bool Split>
[[gnu::always_inline]] inline void synthesize_all(const LegendreStep* steps, int count,
                                                  const LegendreRings& rings, double* out, long stride) {
    in_groups<Width, Most>(
        rings.rings, [&]<int N>(int first) __attribute__((always_inline)) {
            synthesize_rings<Width, N, Split>(steps, count, rings, first, out, stride);
        });
}

template <int Width, int Most, bool Split>
[[gnu::always_inline]] inline void analyze_all(LegendreStep* steps, int count, const LegendreRings& rings,
                                               const double* in, long stride) {
    for (int i = 0; i < count; ++i)
        for (double& f : steps[i].f) f = 0;
    in_groups<Width, Most>(
        rings.rings, [&]<int N>(int first) __attribute__((always_inline)) {
            analyze_rings<Width, N, Split>(steps, count, rings, first, in, stride);
        });
}

}  // namespace

void synthesize(const LegendreStep* steps, int count, const LegendreRings& rings, bool split, double* out,
                long stride) {
    if (split) {
        dispatch<synthesize_all<2, 2, true>, synthesize_all<4, 2, true>, synthesize_all<8, 3, true>>(
            steps, count, rings, out, stride);
    } else {
        dispatch<synthesize_all<2, 2, false>, synthesize_all<4, 2, false>, synthesize_all<8, 4, false>>(
            steps, count, rings, out, stride);
    }
}

void analyze(LegendreStep* steps, int count, const LegendreRings& rings, bool split, const double* in,
             long stride) {
    if (split) {
        dispatch<analyze_all<2, 2, true>, analyze_all<4, 2, true>, analyze_all<8, 3, true>>(
            steps, count, rings, in, stride);
    } else {
        dispatch<analyze_all<2, 2, false>, analyze_all<4, 2, false>, analyze_all<8, 4, false>>(
            steps, count, rings, in, stride);
    }
}

}  // namespace nicol
