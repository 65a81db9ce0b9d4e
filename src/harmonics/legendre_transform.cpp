// SPDX-License-Identifier: MIT
// The Legendre step: for each degree, one recursion over l for s0 and s3 and two for s1 + i s2, on all rings
// at once. A ring in the north and its mirror image share them, as d^l_{mn}(pi - theta) = (-1)^(l+m)
// d^l_{m,-n}(theta).
#include <algorithm>
#include <numbers>
#include <utility>

#include "harmonics/scaled.hpp"
#include "harmonics/vector_kernel.hpp"
#include "nicol/transform.hpp"

namespace nicol {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// Products of square roots that make the steps of every recursion.
struct RootTables {
    explicit RootTables(int order)
        : root(2 * static_cast<std::size_t>(order) + 4), inverse_root(root.size()), inverse_ll(root.size()) {
        for (std::size_t k = 1; k < root.size(); ++k) {
            root[k] = std::sqrt(static_cast<double>(k));
            inverse_root[k] = 1 / root[k];
            inverse_ll[k] = 1 / (static_cast<double>(k) * static_cast<double>(k + 1));
        }
        for (std::size_t s = 0; s < 2; ++s) {
            up[s].resize(static_cast<std::size_t>(order) + 2);
            down[s].resize(up[s].size());
            for (std::size_t l = 2 * s; l < up[s].size(); ++l) {
                const double k = static_cast<double>(l) + 1;
                const double n = 2.0 * static_cast<double>(s);
                up[s][l] = k * std::sqrt((2 * k - 1) * (2 * k + 1) / ((k - n) * (k + n)));
                down[s][l] = 1 / up[s][l];
            }
        }
    }

    std::vector<double> root, inverse_root, inverse_ll;
    std::vector<double> up[2], down[2];  // by |spin| / 2, then l
};

/// Recursion at degree m and second index n (0 or +-2) from `first` to `order`, for harmonics with their
/// norm.
void fill_steps(const RootTables& tables, int m, int n, int first, int order, LegendreStep* steps) {
    const double* up = tables.up[n != 0 ? 1 : 0].data();
    const double* down = tables.down[n != 0 ? 1 : 0].data();
    const double* root = tables.root.data();
    const double* inverse_root = tables.inverse_root.data();
    const double mn = static_cast<double>(m) * n;
    for (int l = first; l <= order; ++l) {
        const double a = up[l] * inverse_root[l + 1 - m] * inverse_root[l + 1 + m];
        LegendreStep& s = steps[l - first];
        s.p = a * (1 - mn * tables.inverse_ll[static_cast<std::size_t>(l)]);
        s.q = a;
        s.c = l == first ? 0 : a * (down[l - 1] * root[l - m] * root[l + m]);
    }
}

/// Whether there are coefficients of s0 or s3, and of s1 + i s2: what is zero is not computed.
struct Contents {
    bool scalar = false;
    bool spin = false;
};

Contents contents(std::span<const double> f) {
    Contents out;
    for (std::size_t i = 0; i < f.size(); i += 4) {
        out.scalar = out.scalar || f[i] != 0 || f[i + 3] != 0;
        out.spin = out.spin || (i >= 4 * psh_index(2, -2) && (f[i + 1] != 0 || f[i + 2] != 0));
        if (out.scalar && out.spin) break;
    }
    return out;
}

bool any(const std::vector<Complex>& values) {
    return std::ranges::any_of(values, [](Complex v) { return v != Complex(); });
}

/// Below this many units of -log, a harmonic is taken for zero on a ring.
constexpr double kNegligible = 60;

}  // namespace

struct LegendreTransform::Plan {
    /// A latitude of the northern half and the rows at it and at its mirror image; -1 where there is none.
    struct Ring {
        HalfAngle half;
        int north = -1;
        int south = -1;
    };

    Plan(int order_, LatitudeRows rows_)
        : order(order_), rows(std::move(rows_)), tables(order_), rings(pair_rows(rows)) {
        std::ranges::sort(rings, {}, [](const Ring& r) { return r.half.sin; });
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
                for (const Ring& ring : rings) beginnings.push_back(first_value(m, n, ring.half));
        steps.resize(static_cast<std::size_t>(order) + 1);
        sums.resize(8 * padded);
        work.resize(steps.size() * 4 * kRingLanes);
    }

    static std::vector<Ring> pair_rows(const LatitudeRows& rows) {
        std::vector<Ring> out;
        const int count = rows.count();
        for (int j = 0; j < count; ++j) {
            const auto a = static_cast<std::size_t>(j);
            const auto b = static_cast<std::size_t>(count - 1 - j);
            const bool mirrored =
                rows.sin_half[a] == rows.cos_half[b] && rows.cos_half[a] == rows.sin_half[b];
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

    /// First values at degree m of the chains n = 0, -2, 2, called for m = 0, 1, 2 ... in turn.
    void start_degree(int m) {
        if (m == 0) skipped = 0;
        for (std::size_t c = 0; c < 3; ++c) {
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
        // Rings so near the pole that this and every higher degree vanishes on them, by the decay of the
        // harmonics below their turning point (with two to spare for the spin).
        while (skipped < rings.size() && m > 2) {
            const HalfAngle& half = rings[skipped].half;
            const double x = (order + 1) * 2 * half.sin * half.cos / (m - 2);
            if (x >= 1) break;
            const double decay = x == 0 ? 1e300 : std::acosh(1 / x) - std::sqrt(1 - x * x);
            if ((m - 2) * decay < kNegligible) break;
            ++skipped;
        }
    }

    /// Rings of chain c, from the first whole group that is not skipped.
    LegendreRings start(std::size_t c, int first) {
        from = skipped / kRingLanes * kRingLanes;
        const double norm = std::sqrt((2 * first + 1) / (4 * pi));
        for (std::size_t r = from; r < rings.size(); ++r) {
            const bool gone = r < skipped;
            value[r] = gone ? 0 : norm * chains[c][r].v;
            exponent[r] = gone ? 0 : chains[c][r].e;
        }
        return {t.data() + from, value.data() + from, exponent.data() + from,
                static_cast<int>(padded - from)};
    }

    void synthesize(std::size_t c, int first, bool split) {
        const LegendreRings r = start(c, first);
        for (std::size_t k = 0; k < 8; ++k)
            std::fill_n(sums.begin() + static_cast<std::ptrdiff_t>(k * padded), from, 0.0);
        kernel.synthesize(steps.data(), order - first + 1, r, split, sums.data() + from,
                          static_cast<long>(padded));
    }

    void analyze(std::size_t c, int first, bool split) {
        const LegendreRings r = start(c, first);
        kernel.analyze(steps.data(), order - first + 1, r, split, sums.data() + from,
                       static_cast<long>(padded), work.data());
    }

    double& sum(std::size_t k, std::size_t ring) { return sums[k * padded + ring]; }

    static constexpr int kSecond[3] = {0, -2, 2};

    int order;
    LatitudeRows rows;
    RootTables tables;
    std::vector<Ring> rings;
    const VectorKernel& kernel = vector_kernel();
    std::size_t padded = 0;
    std::size_t skipped = 0;
    std::size_t from = 0;
    std::vector<double> t, value;
    std::vector<int> exponent;
    std::vector<Scaled> first_step;
    std::vector<Scaled> chains[3];
    std::vector<Scaled> beginnings;  // [m = 0..2][chain][ring]
    std::vector<LegendreStep> steps;
    std::vector<double> sums;  // [8][padded]
    std::vector<double> work;
};

LegendreTransform::LegendreTransform(int order, LatitudeRows rows) {
    require_order(order);
    const std::size_t n = rows.theta.size();
    require(n >= 1, "rows is empty");
    require_size(rows.sin_half.size(), n, "rows.sin_half");
    require_size(rows.cos_half.size(), n, "rows.cos_half");
    require_size(rows.weight.size(), n, "rows.weight");
    for (std::size_t j = 0; j < n; ++j) {
        const double s = rows.sin_half[j];
        const double c = rows.cos_half[j];
        require(s >= 0 && c >= 0 && std::abs(s * s + c * c - 1) < 1e-12 && std::isfinite(rows.weight[j]),
                "row " + std::to_string(j) + " has no colatitude in [0, pi] or no finite weight");
    }
    plan_ = std::make_unique<Plan>(order, std::move(rows));
}
LegendreTransform::~LegendreTransform() = default;
LegendreTransform::LegendreTransform(LegendreTransform&&) noexcept = default;
LegendreTransform& LegendreTransform::operator=(LegendreTransform&&) noexcept = default;

int LegendreTransform::order() const noexcept {
    return plan_->order;
}
const LatitudeRows& LegendreTransform::rows() const noexcept {
    return plan_->rows;
}

void LegendreTransform::synthesize(std::span<const double> f, FourierRows& fourier) {
    Plan& p = *plan_;
    require_size(f.size(), 4 * psh_count(p.order), "coefficients");
    require(fourier.order == p.order && fourier.rows == p.rows.count(),
            "fourier has another order or row count");
    const auto [has_scalar, has_spin] = contents(f);
    if (!has_scalar) {
        std::ranges::fill(fourier.s0, Complex());
        std::ranges::fill(fourier.s3, Complex());
    }
    if (!has_spin) std::ranges::fill(fourier.spin, Complex());
    for (int m = 0; m <= p.order; ++m) {
        p.start_degree(m);
        if (has_scalar) {
            fill_steps(p.tables, m, 0, m, p.order, p.steps.data());
            for (int l = m; l <= p.order; ++l) {
                const double* plus = &f[4 * psh_index(l, m)];
                const double* minus = &f[4 * psh_index(l, -m)];
                double* out = p.steps[static_cast<std::size_t>(l - m)].f;
                const double half = m == 0 ? 1 : std::numbers::sqrt2 / 2;
                const double sine = m == 0 ? 0 : -half;
                out[0] = half * plus[0];
                out[1] = sine * minus[0];
                out[2] = half * plus[3];
                out[3] = sine * minus[3];
            }
            p.synthesize(0, m, true);
            for (std::size_t r = 0; r < p.rings.size(); ++r) {
                const Complex even0(p.sum(0, r), p.sum(1, r));
                const Complex even3(p.sum(2, r), p.sum(3, r));
                const Complex odd0(p.sum(4, r), p.sum(5, r));
                const Complex odd3(p.sum(6, r), p.sum(7, r));
                if (const int row = p.rings[r].north; row >= 0) {
                    fourier.s0[fourier.scalar_index(row, m)] = even0 + odd0;
                    fourier.s3[fourier.scalar_index(row, m)] = even3 + odd3;
                }
                if (const int row = p.rings[r].south; row >= 0) {
                    fourier.s0[fourier.scalar_index(row, m)] = even0 - odd0;
                    fourier.s3[fourier.scalar_index(row, m)] = even3 - odd3;
                }
            }
        }
        if (!has_spin) continue;
        const int first = std::max(m, 2);
        for (const int n : {-2, 2}) {
            // n = -2 makes degree m in the north and -m in the south, n = 2 the other two.
            if (m == 0 && n == 2) continue;
            fill_steps(p.tables, m, n, first, p.order, p.steps.data());
            const int north = n < 0 ? m : -m;
            const double sign = n < 0 ? 1 : parity(m);
            for (int l = first; l <= p.order; ++l) {
                const double* a = &f[4 * psh_index(l, north)];
                const double* b = &f[4 * psh_index(l, -north)];
                double* out = p.steps[static_cast<std::size_t>(l - first)].f;
                const double south_sign = sign * parity(l);
                out[0] = sign * a[1];
                out[1] = sign * a[2];
                out[2] = south_sign * b[1];
                out[3] = south_sign * b[2];
            }
            p.synthesize(n < 0 ? 1 : 2, first, false);
            for (std::size_t r = 0; r < p.rings.size(); ++r) {
                if (const int row = p.rings[r].north; row >= 0)
                    fourier.spin[fourier.spin_index(row, north)] = {p.sum(0, r), p.sum(1, r)};
                if (const int row = p.rings[r].south; row >= 0)
                    fourier.spin[fourier.spin_index(row, -north)] = {p.sum(2, r), p.sum(3, r)};
            }
        }
    }
}

void LegendreTransform::analyze(const FourierRows& fourier, std::span<double> f) {
    Plan& p = *plan_;
    require_size(f.size(), 4 * psh_count(p.order), "coefficients");
    require(fourier.order == p.order && fourier.rows == p.rows.count(),
            "fourier has another order or row count");
    std::ranges::fill(f, 0.0);
    const bool has_scalar = any(fourier.s0) || any(fourier.s3);
    const bool has_spin = p.order >= 2 && any(fourier.spin);
    const auto weighted = [&](int row, Complex value) {
        return row < 0 ? Complex() : 2 * pi * p.rows.weight[static_cast<std::size_t>(row)] * value;
    };
    for (int m = 0; m <= p.order; ++m) {
        p.start_degree(m);
        if (has_scalar) {
            fill_steps(p.tables, m, 0, m, p.order, p.steps.data());
            for (std::size_t r = 0; r < p.rings.size(); ++r) {
                const Plan::Ring& ring = p.rings[r];
                for (std::size_t k = 0; k < 4; k += 2) {
                    const std::vector<Complex>& g = k == 0 ? fourier.s0 : fourier.s3;
                    const Complex north = ring.north < 0
                                              ? Complex()
                                              : weighted(ring.north, g[fourier.scalar_index(ring.north, m)]);
                    const Complex south = ring.south < 0
                                              ? Complex()
                                              : weighted(ring.south, g[fourier.scalar_index(ring.south, m)]);
                    p.sum(k, r) = north.real() + south.real();
                    p.sum(k + 1, r) = north.imag() + south.imag();
                    p.sum(k + 4, r) = north.real() - south.real();
                    p.sum(k + 5, r) = north.imag() - south.imag();
                }
            }
            p.analyze(0, m, true);
            for (int l = m; l <= p.order; ++l) {
                const double* in = p.steps[static_cast<std::size_t>(l - m)].f;
                double* plus = &f[4 * psh_index(l, m)];
                double* minus = &f[4 * psh_index(l, -m)];
                if (m > 0) {
                    minus[0] = -std::numbers::sqrt2 * in[1];
                    minus[3] = -std::numbers::sqrt2 * in[3];
                }
                plus[0] = m == 0 ? in[0] : std::numbers::sqrt2 * in[0];
                plus[3] = m == 0 ? in[2] : std::numbers::sqrt2 * in[2];
            }
        }
        if (!has_spin) continue;
        const int first = std::max(m, 2);
        for (const int n : {-2, 2}) {
            if (m == 0 && n == 2) continue;
            fill_steps(p.tables, m, n, first, p.order, p.steps.data());
            const int north = n < 0 ? m : -m;
            const double sign = n < 0 ? 1 : parity(m);
            for (std::size_t r = 0; r < p.rings.size(); ++r) {
                const Plan::Ring& ring = p.rings[r];
                const Complex a =
                    ring.north < 0
                        ? Complex()
                        : weighted(ring.north, fourier.spin[fourier.spin_index(ring.north, north)]);
                const Complex b =
                    ring.south < 0
                        ? Complex()
                        : weighted(ring.south, fourier.spin[fourier.spin_index(ring.south, -north)]);
                p.sum(0, r) = a.real();
                p.sum(1, r) = a.imag();
                p.sum(2, r) = b.real();
                p.sum(3, r) = b.imag();
            }
            p.analyze(n < 0 ? 1 : 2, first, false);
            for (int l = first; l <= p.order; ++l) {
                const double* in = p.steps[static_cast<std::size_t>(l - first)].f;
                double* a = &f[4 * psh_index(l, north)];
                double* b = &f[4 * psh_index(l, -north)];
                const double south_sign = sign * parity(l);
                a[1] += sign * in[0];
                a[2] += sign * in[1];
                b[1] += south_sign * in[2];
                b[2] += south_sign * in[3];
            }
        }
    }
}

}  // namespace nicol
