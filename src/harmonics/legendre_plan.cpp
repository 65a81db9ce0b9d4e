// SPDX-License-Identifier: MIT
#include "harmonics/legendre_plan.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

namespace nicol {
namespace {

using std::numbers::pi;

/// Decay of a harmonic, in units of -log, beyond which it counts as zero on a ring.
constexpr double kNegligible = 60;

std::vector<LatitudeRing> pair_rows(const LatitudeRows& rows) {
    std::vector<LatitudeRing> out;
    const int count = rows.count();
    for (int j = 0; j < count; ++j) {
        const auto a = static_cast<std::size_t>(j);
        const auto b = static_cast<std::size_t>(count - 1 - j);
        const bool mirrored = rows.sin_half[a] == rows.cos_half[b] && rows.cos_half[a] == rows.sin_half[b];
        const bool north = rows.sin_half[a] <= rows.cos_half[a];
        if (mirrored && a != b) {
            // The pair counts once, at its northern row.
            if (rows.sin_half[a] < rows.cos_half[a] || (rows.sin_half[a] == rows.cos_half[a] && a < b))
                out.push_back({{rows.sin_half[a], rows.cos_half[a]}, j, count - 1 - j});
        } else if (north) {
            out.push_back({{rows.sin_half[a], rows.cos_half[a]}, j, -1});
        } else {
            out.push_back({{rows.cos_half[a], rows.sin_half[a]}, -1, j});
        }
    }
    return out;
}

}  // namespace

LegendreTransform::Plan::Plan(int order_, LatitudeRows rows_)
    : order(order_), rows(std::move(rows_)), rings(pair_rows(rows)), tables(order_) {
    std::ranges::sort(rings, {}, [](const LatitudeRing& r) { return r.half.sin; });
    for (LatitudeRing& ring : rings) {
        if (ring.north >= 0) ring.north_weight = 2 * pi * rows.weight[static_cast<std::size_t>(ring.north)];
        if (ring.south >= 0) ring.south_weight = 2 * pi * rows.weight[static_cast<std::size_t>(ring.south)];
    }
    const std::size_t lanes = kRingLanes;
    padded = (rings.size() + lanes - 1) / lanes * lanes;
    t.resize(padded);
    value.resize(padded);
    exponent.resize(padded);
    for (std::size_t r = 0; r < rings.size(); ++r) {
        t[r] = 2 * rings[r].half.sin * rings[r].half.sin;
        Scaled step(rings[r].half.sin);
        step *= Scaled(rings[r].half.cos);
        first_step.push_back(step);
    }
    for (auto& chain : chains) chain.resize(rings.size());
    for (int m = 0; m <= 2; ++m)
        for (const int n : kSecond)
            for (const LatitudeRing& ring : rings) beginnings.push_back(first_value(m, n, ring.half));
    steps.resize(static_cast<std::size_t>(order) + 1);
    sums.resize(8 * padded);
}

void LegendreTransform::Plan::start_degree(int m, bool scalar, bool spin) {
    if (m == 0) skipped = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        if (c == 0 ? !scalar : !spin) continue;
        const int n = kSecond[c];
        const int inner = std::abs(n);
        const double ratio = m > inner ? -next_first_ratio(m - 1, n) : 0;
        for (std::size_t r = skipped; r < rings.size(); ++r) {
            if (m <= inner) {
                chains[c][r] = beginnings[(static_cast<std::size_t>(m) * 3 + c) * rings.size() + r];
            } else {
                chains[c][r].multiply(first_step[r], ratio);
            }
        }
    }
    // Skips rings so near the pole that this and every higher degree vanish on them, because the harmonics
    // decay below their turning point (with a margin of two for the spin).
    while (skipped < rings.size() && m > 2) {
        const HalfAngle& half = rings[skipped].half;
        const double x = (order + 1) * 2 * half.sin * half.cos / (m - 2);
        if (x >= 1) break;
        const double decay = x == 0 ? 1e300 : std::acosh(1 / x) - std::sqrt(1 - x * x);
        if ((m - 2) * decay < kNegligible) break;
        ++skipped;
    }
}

void LegendreTransform::Plan::fill_steps(std::size_t c, int m, int first) {
    const double* up = tables.up[c > 0 ? 1 : 0].data();
    const double* down = tables.down[c > 0 ? 1 : 0].data();
    const double* root = tables.root.data();
    const double* inverse_root = tables.inverse_root.data();
    const double mn = static_cast<double>(m) * kSecond[c];
    for (int l = first; l <= order; ++l) {
        const double a = up[l] * inverse_root[l + 1 - m] * inverse_root[l + 1 + m];
        LegendreStep& s = steps[static_cast<std::size_t>(l - first)];
        s.p = a * (1 - mn * tables.inverse_ll[static_cast<std::size_t>(l)]);
        s.q = a;
        s.c = l == first ? 0 : a * (down[l - 1] * root[l - m] * root[l + m]);
    }
}

/// Returns the rings of chain c, from the first whole group that is not skipped.
LegendreRings LegendreTransform::Plan::start(std::size_t c, int first) {
    from = skipped / kRingLanes * kRingLanes;
    const double norm = std::sqrt((2 * first + 1) / (4 * pi));
    for (std::size_t r = from; r < rings.size(); ++r) {
        const bool gone = r < skipped;
        value[r] = gone ? 0 : norm * chains[c][r].v;
        exponent[r] = gone ? 0 : chains[c][r].e;
    }
    return {t.data() + from, value.data() + from, exponent.data() + from, static_cast<int>(padded - from)};
}

void LegendreTransform::Plan::synthesize(std::size_t c, int first, bool split) {
    const LegendreRings r = start(c, first);
    for (std::size_t k = 0; k < 8; ++k)
        std::fill_n(sums.begin() + static_cast<std::ptrdiff_t>(k * padded), from, 0.0);
    nicol::synthesize(steps.data(), order - first + 1, r, split, sums.data() + from,
                      static_cast<long>(padded));
}

void LegendreTransform::Plan::analyze(std::size_t c, int first, bool split) {
    const LegendreRings r = start(c, first);
    nicol::analyze(steps.data(), order - first + 1, r, split, sums.data() + from, static_cast<long>(padded));
}

}  // namespace nicol
