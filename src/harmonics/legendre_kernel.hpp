// SPDX-License-Identifier: MIT
// The recursion of the Legendre step over vectors of rings; part of vector_kernel_impl.hpp.
#pragma once

#include "harmonics/vectors.hpp"

namespace nicol {
namespace {

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

template <int N, bool Split>
void analyze_rings(const LegendreStep* steps, int count, const LegendreRings& rings, int first,
                   const double* in, long stride, double* work) {
    State<N> state;
    state.load(rings, first);
    Vector even[4][N];
    Vector odd[Split ? 4 : 1][Split ? N : 1];
    for (int k = 0; k < 4; ++k)
        for (int v = 0; v < N; ++v) {
            even[k][v] = at(in + k * stride + first + v * kLanes);
            if constexpr (Split) odd[k][v] = at(in + (4 + k) * stride + first + v * kLanes);
        }
    const auto add_even = [&](double* sum, const Vector* y) {
        for (int k = 0; k < 4; ++k) {
            Vector dot = even[k][0] * y[0];
            for (int v = 1; v < N; ++v) dot += even[k][v] * y[v];
            at(sum + k * kLanes) += dot;
        }
    };
    const auto add_odd = [&](double* sum, const Vector* y) {
        if constexpr (Split) {
            for (int k = 0; k < 4; ++k) {
                Vector dot = odd[k][0] * y[0];
                for (int v = 1; v < N; ++v) dot += odd[k][v] * y[v];
                at(sum + k * kLanes) += dot;
            }
        } else {
            add_even(sum, y);
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
                    add_even(work + i * 4 * kLanes, y);
                else
                    add_odd(work + i * 4 * kLanes, y);
                state.advance(steps[i]);
            }
        } else {
            for (; i < end; ++i) state.advance(steps[i]);
        }
        state.rescale();
    }
    Vector t[N], y[N], z[N];
    for (int v = 0; v < N; ++v) {
        t[v] = state.t[v];
        y[v] = state.y[v];
        z[v] = state.before[v];
    }
    for (; i + 2 <= count; i += 2) {
        const LegendreStep& a = steps[i];
        const LegendreStep& b = steps[i + 1];
        add_even(work + i * 4 * kLanes, y);
        for (int v = 0; v < N; ++v) z[v] = (a.p - a.q * t[v]) * y[v] - a.c * z[v];
        add_odd(work + (i + 1) * 4 * kLanes, z);
        for (int v = 0; v < N; ++v) y[v] = (b.p - b.q * t[v]) * z[v] - b.c * y[v];
    }
    if (i < count) add_even(work + i * 4 * kLanes, y);
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
void analyze_all(LegendreStep* steps, int count, const LegendreRings& rings, const double* in, long stride,
                 double* work) {
    for (int i = 0; i < count * 4 * kLanes; ++i) work[i] = 0;
    in_groups<Split ? NICOL_SPLIT_VECTORS : NICOL_VECTORS>(rings.rings, [&]<int N>(int first) {
        analyze_rings<N, Split>(steps, count, rings, first, in, stride, work);
    });
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 4; ++k) {
            double* lanes = work + (i * 4 + k) * kLanes;
            for (int half = kLanes / 2; half > 0; half /= 2)
                for (int lane = 0; lane < half; ++lane) lanes[lane] += lanes[lane + half];
            steps[i].f[k] = lanes[0];
        }
}

void analyze(LegendreStep* steps, int count, const LegendreRings& rings, bool split, const double* in,
             long stride, double* work) {
    if (split)
        analyze_all<true>(steps, count, rings, in, stride, work);
    else
        analyze_all<false>(steps, count, rings, in, stride, work);
}

}  // namespace
}  // namespace nicol
