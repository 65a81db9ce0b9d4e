// SPDX-License-Identifier: MIT
// The Legendre step.
#include <algorithm>
#include <numbers>
#include <utility>

#include "harmonics/require.hpp"
#include "nicol/spin_harmonics.hpp"
#include "nicol/transform.hpp"

namespace nicol {

using Complex = std::complex<double>;

struct LegendreTransform::Plan {
    int order;
    LatitudeRows rows;
    std::vector<double> scalar, spin2;
    std::vector<Complex> sum;
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
    const std::size_t count = psh_count(order);
    plan_ = std::make_unique<Plan>(
        Plan{order, std::move(rows), std::vector<double>(count), std::vector<double>(count), {}});
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

void LegendreTransform::analyze(const FourierRows& fourier, std::span<double> f) {
    Plan& p = *plan_;
    require_size(f.size(), 4 * psh_count(p.order), "coefficients");
    require(fourier.order == p.order && fourier.rows == p.rows.count(),
            "fourier has another order or row count");
    std::ranges::fill(f, 0.0);
    for (int row = 0; row < fourier.rows; ++row) {
        const auto r = static_cast<std::size_t>(row);
        spin_harmonics(0, p.order, p.rows.sin_half[r], p.rows.cos_half[r], p.scalar);
        spin_harmonics(2, p.order, p.rows.sin_half[r], p.rows.cos_half[r], p.spin2);
        const double weight = 2 * std::numbers::pi * p.rows.weight[r];
        for (int l = 0; l <= p.order; ++l)
            for (int m = -l; m <= l; ++m) {
                const std::size_t i = psh_index(l, m);
                const std::size_t g = fourier.scalar_index(row, std::abs(m));
                const double y =
                    weight * p.scalar[psh_index(l, std::abs(m))] * (m == 0 ? 1 : std::numbers::sqrt2);
                const Complex w = fourier.spin[fourier.spin_index(row, m)];
                f[4 * i] += y * (m >= 0 ? fourier.s0[g].real() : -fourier.s0[g].imag());
                f[4 * i + 1] += weight * p.spin2[i] * w.real();
                f[4 * i + 2] += weight * p.spin2[i] * w.imag();
                f[4 * i + 3] += y * (m >= 0 ? fourier.s3[g].real() : -fourier.s3[g].imag());
            }
    }
}

void LegendreTransform::synthesize(std::span<const double> f, FourierRows& fourier) {
    Plan& p = *plan_;
    require_size(f.size(), 4 * psh_count(p.order), "coefficients");
    require(fourier.order == p.order && fourier.rows == p.rows.count(),
            "fourier has another order or row count");
    std::ranges::fill(fourier.s0, Complex());
    std::ranges::fill(fourier.s3, Complex());
    std::ranges::fill(fourier.spin, Complex());
    for (int row = 0; row < fourier.rows; ++row) {
        const auto r = static_cast<std::size_t>(row);
        spin_harmonics(0, p.order, p.rows.sin_half[r], p.rows.cos_half[r], p.scalar);
        spin_harmonics(2, p.order, p.rows.sin_half[r], p.rows.cos_half[r], p.spin2);
        for (int l = 0; l <= p.order; ++l)
            for (int m = -l; m <= l; ++m) {
                const std::size_t i = psh_index(l, m);
                const std::size_t j = psh_index(l, -m);
                fourier.spin[fourier.spin_index(row, m)] += p.spin2[i] * Complex(f[4 * i + 1], f[4 * i + 2]);
                if (m < 0) continue;
                const double y = p.scalar[i] * (m == 0 ? 1 : std::numbers::sqrt2 / 2);
                const std::size_t g = fourier.scalar_index(row, m);
                fourier.s0[g] += y * Complex(f[4 * i], m == 0 ? 0 : -f[4 * j]);
                fourier.s3[g] += y * Complex(f[4 * i + 3], m == 0 ? 0 : -f[4 * j + 3]);
            }
    }
}

}  // namespace nicol
