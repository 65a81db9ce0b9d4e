// SPDX-License-Identifier: MIT
// The loops of LegendreKernel for vectors of NICOL_LANES doubles; included by one source for each instruction
// set. Nothing here may use a header with inline functions: the linker could pick this file's copy of them
// for a processor that cannot run it.
#include "harmonics/legendre_kernel.hpp"

namespace nicol {
namespace {

constexpr int kLanes = NICOL_LANES;
typedef double Vector __attribute__((vector_size(8 * kLanes)));
typedef long long Mask __attribute__((vector_size(8 * kLanes)));
typedef double Unaligned __attribute__((vector_size(8 * kLanes), aligned(8), may_alias));

inline const Unaligned& at(const double* p) {
    return *reinterpret_cast<const Unaligned*>(p);
}
inline Unaligned& at(double* p) {
    return *reinterpret_cast<Unaligned*>(p);
}

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

template <bool Split>
void synthesize_all(const LegendreStep* steps, int count, const LegendreRings& rings, double* out,
                    long stride) {
    int first = 0;
    for (; first + NICOL_VECTORS * kLanes <= rings.rings; first += NICOL_VECTORS * kLanes)
        synthesize_rings<NICOL_VECTORS, Split>(steps, count, rings, first, out, stride);
    for (; first < rings.rings; first += kLanes)
        synthesize_rings<1, Split>(steps, count, rings, first, out, stride);
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
    int first = 0;
    for (; first + NICOL_VECTORS * kLanes <= rings.rings; first += NICOL_VECTORS * kLanes)
        analyze_rings<NICOL_VECTORS, Split>(steps, count, rings, first, in, stride, work);
    for (; first < rings.rings; first += kLanes)
        analyze_rings<1, Split>(steps, count, rings, first, in, stride, work);
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 4; ++k) {
            const double* lanes = work + (i * 4 + k) * kLanes;
            double sum = 0;
            for (int lane = 0; lane < kLanes; ++lane) sum += lanes[lane];
            steps[i].f[k] = sum;
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

extern const LegendreKernel NICOL_KERNEL;
const LegendreKernel NICOL_KERNEL = {synthesize, analyze};

}  // namespace nicol
