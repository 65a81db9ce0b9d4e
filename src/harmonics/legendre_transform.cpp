// SPDX-License-Identifier: MIT
// Legendre step of the transform: from coefficients to the steps of the recurrences, from sums on rings to
// rows, and back.
#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

#include "harmonics/legendre_plan.hpp"

namespace nicol {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

/// Whether there are coefficients of s0 or s3, and of s1 + i s2. Parts that are zero are not computed.
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

// Both functions have loops without an early exit, because such loops vectorise.
bool any(const std::vector<Complex>& values) {
    int found = 0;
    for (const Complex& v : values) found |= (v.real() != 0 ? 1 : 0) | (v.imag() != 0 ? 1 : 0);
    return found != 0;
}

bool all_finite(std::span<const double> values) {
    bool finite = true;
    for (const double v : values) finite &= std::abs(v) <= std::numeric_limits<double>::max();
    return finite;
}

}  // namespace

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
    require_finite(f, "coefficients");
    const auto [has_scalar, has_spin] = contents(f);
    if (!has_scalar) {
        std::ranges::fill(fourier.s0, Complex());
        std::ranges::fill(fourier.s3, Complex());
    }
    if (!has_spin) std::ranges::fill(fourier.spin, Complex());
    for (int m = 0; m <= p.order; ++m) {
        p.start_degree(m, has_scalar, has_spin);
        if (has_scalar) {
            p.fill_steps(0, m, m);
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
            // n = -2 gives degree m in the north and -m in the south; n = 2 gives -m in the north and m in
            // the south.
            if (m == 0 && n == 2) continue;
            p.fill_steps(n < 0 ? 1 : 2, m, first);
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
    for (int m = 0; m <= p.order; ++m) {
        p.start_degree(m, has_scalar, has_spin);
        if (has_scalar) {
            p.fill_steps(0, m, m);
            for (std::size_t r = 0; r < p.rings.size(); ++r) {
                const LatitudeRing& ring = p.rings[r];
                for (std::size_t k = 0; k < 4; k += 2) {
                    const std::vector<Complex>& g = k == 0 ? fourier.s0 : fourier.s3;
                    const Complex north =
                        ring.north_weight * g[fourier.scalar_index(std::max(ring.north, 0), m)];
                    const Complex south =
                        ring.south_weight * g[fourier.scalar_index(std::max(ring.south, 0), m)];
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
            p.fill_steps(n < 0 ? 1 : 2, m, first);
            const int north = n < 0 ? m : -m;
            const double sign = n < 0 ? 1 : parity(m);
            for (std::size_t r = 0; r < p.rings.size(); ++r) {
                const LatitudeRing& ring = p.rings[r];
                const Complex a =
                    ring.north_weight * fourier.spin[fourier.spin_index(std::max(ring.north, 0), north)];
                const Complex b =
                    ring.south_weight * fourier.spin[fourier.spin_index(std::max(ring.south, 0), -north)];
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
    // A sample that is not finite has spread to the coefficients of its row's harmonics.
    require(all_finite(f),
            "the coefficients are not finite: a sample is not a number, infinite or too large");
}

}  // namespace nicol
