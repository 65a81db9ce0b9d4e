// SPDX-License-Identifier: MIT
#include "harmonics/low_degrees.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simd/dispatch.hpp"
#include "simd/double_vectors.hpp"

namespace nicol {
namespace {

using Four = DoubleVectors<4>::Vector;

// Adds `N` degrees, every second one, each with its cosine and its sine: 2 N chains of additions.
template <int N>
[[gnu::always_inline]] inline void add_degrees(const double* cosine, const double* sine, long count,
                                               const double* table, double* sums) {
    Four sum[2 * N] = {};
    for (long i = 0; i < count; ++i) {
        Four c;
        Four s;
        load_vector(cosine + 4 * i, c);
        load_vector(sine + 4 * i, s);
        for (int k = 0; k < N; ++k) {
            const double* pair = table + 4 * k * count + 2 * i;
            sum[2 * k] += pair[0] * c;
            sum[2 * k + 1] += pair[1] * s;
        }
    }
    for (int k = 0; k < N; ++k) {
        add_vector(sums + 16 * k, sum[2 * k]);
        add_vector(sums + 16 * k + 4, sum[2 * k + 1]);
    }
}

[[gnu::always_inline]] inline void add_all(const double* folded, int count, const double* table, int degrees,
                                           double* sums) {
    const long n = count;
    for (int parity = 0; parity < 2; ++parity) {
        const double* cosine = folded + 4 * parity * n;
        const double* sine = folded + 4 * (2 + parity) * n;
        for (int m = parity; m < degrees;) {
            const int left = (degrees - m + 1) / 2;
            const double* a = table + 2 * m * n;
            double* out = sums + 8 * m;
            if (left == 4 || left > 5) {
                add_degrees<4>(cosine, sine, n, a, out);
                m += 8;
            } else if (left >= 3) {
                add_degrees<3>(cosine, sine, n, a, out);
                m += 6;
            } else if (left == 2) {
                add_degrees<2>(cosine, sine, n, a, out);
                m += 4;
            } else {
                add_degrees<1>(cosine, sine, n, a, out);
                m += 2;
            }
        }
    }
}

}  // namespace

void add_low_degrees(const double* folded, int count, const double* table, int degrees, double* sums) {
    dispatch<add_all>(folded, count, table, degrees, sums);
}

LowDegrees::LowDegrees(int order, int columns)
    : order_(order),
      columns_(columns),
      folded_(16 * kBlock),
      sums_(8 * (static_cast<std::size_t>(order) + 1)) {
    // Columns 0 to columns / 4. The first and the last column stand for two points of the row, the others for
    // four.
    const int quarter = columns / 4;
    for (int first = 0; first <= quarter; first += kBlock)
        for (int m = 0; m <= order; ++m)
            for (int c = first; c < std::min(first + kBlock, quarter + 1); ++c) {
                const long long turn = static_cast<long long>(m) * c % columns;
                const double angle = 2 * std::numbers::pi * static_cast<double>(turn) / columns;
                table_.push_back(std::cos(angle));
                table_.push_back(std::sin(angle));
            }
}

std::span<const double> LowDegrees::sums(std::span<const double> samples) {
    std::ranges::fill(sums_, 0.0);
    const int quarter = columns_ / 4;
    const double* table = table_.data();
    for (int first = 0; first <= quarter; first += kBlock) {
        const int count = std::min(kBlock, quarter + 1 - first);
        const long set = 4L * count;
        for (int i = 0; i < count; ++i) {
            const int c = first + i;
            const double weight = c == 0 || c == quarter ? .5 : 1;
            const double* a = samples.data() + 4L * c;
            const double* b = samples.data() + 4L * (columns_ / 2 - c);
            const double* d = samples.data() + 4L * (columns_ / 2 + c);
            const double* e = samples.data() + 4L * (c == 0 ? 0 : columns_ - c);
            double* to = folded_.data() + 4L * i;
            for (int p = 0; p < 4; ++p) {
                const double near_sum = weight * (a[p] + e[p]);
                const double far_sum = weight * (b[p] + d[p]);
                const double near_gap = weight * (a[p] - e[p]);
                const double far_gap = weight * (d[p] - b[p]);
                to[p] = near_sum + far_sum;
                to[set + p] = near_sum - far_sum;
                to[2 * set + p] = near_gap + far_gap;
                to[3 * set + p] = near_gap - far_gap;
            }
        }
        add_low_degrees(folded_.data(), count, table, order_ + 1, sums_.data());
        table += 2L * count * (order_ + 1);
    }
    return sums_;
}

}  // namespace nicol
