// SPDX-License-Identifier: MIT
// The Fourier step: s0 + i s3 and s1 + i s2 are one complex FFT each.
#include <cmath>
#include <kissfft/kissfft.hh>
#include <numbers>

#include "harmonics/require.hpp"
#include "nicol/transform.hpp"

namespace nicol {

using Complex = std::complex<double>;

FourierRows::FourierRows(int order_, int rows_) : order(order_), rows(rows_) {
    require_order(order);
    require(rows >= 1, "rows is " + std::to_string(rows) + ", expected at least 1");
    const auto r = static_cast<std::size_t>(rows);
    const auto n = static_cast<std::size_t>(order) + 1;
    s0.resize(r * n);
    s3.resize(r * n);
    spin.resize(r * (2 * n - 1));
}

struct FourierTransform::Plan {
    int order;
    int columns;
    kissfft<double> forward;
    kissfft<double> backward;
    std::vector<Complex> phase;  // exp(i m phi0)
    std::vector<Complex> scalar_in, spin_in, scalar_out, spin_out;

    Plan(int order_, int columns_, double phi0)
        : order(order_),
          columns(columns_),
          forward(static_cast<std::size_t>(columns_), false),
          backward(static_cast<std::size_t>(columns_), true),
          phase(static_cast<std::size_t>(order_) + 1),
          scalar_in(static_cast<std::size_t>(columns_)),
          spin_in(scalar_in),
          scalar_out(scalar_in),
          spin_out(scalar_in) {
        for (int m = 0; m <= order; ++m) phase[static_cast<std::size_t>(m)] = std::polar(1.0, m * phi0);
    }
    /// Where degree m stands in a transform.
    [[nodiscard]] std::size_t bin(int m) const { return static_cast<std::size_t>(m >= 0 ? m : m + columns); }
};

FourierTransform::FourierTransform(int order, int columns, double phi0) {
    require_order(order);
    require(columns >= 2 * order + 1 && columns <= kMaxColumns,
            "columns is " + std::to_string(columns) + ", expected " + std::to_string(2 * order + 1) + " to " +
                std::to_string(kMaxColumns) + " for order " + std::to_string(order));
    require(std::isfinite(phi0), "phi0 is not finite");
    plan_ = std::make_unique<Plan>(order, columns, phi0);
}
FourierTransform::~FourierTransform() = default;
FourierTransform::FourierTransform(FourierTransform&&) noexcept = default;
FourierTransform& FourierTransform::operator=(FourierTransform&&) noexcept = default;

int FourierTransform::order() const noexcept {
    return plan_->order;
}
int FourierTransform::columns() const noexcept {
    return plan_->columns;
}

namespace {

void require_row(const FourierRows& fourier, int order, int row) {
    require(fourier.order == order,
            "fourier has order " + std::to_string(fourier.order) + ", expected " + std::to_string(order));
    require(row >= 0 && row < fourier.rows,
            "row is " + std::to_string(row) + ", fourier has " + std::to_string(fourier.rows));
}

}  // namespace

void FourierTransform::analyze(std::span<const double> samples, FourierRows& fourier, int row) {
    Plan& p = *plan_;
    const auto columns = static_cast<std::size_t>(p.columns);
    require_size(samples.size(), 4 * columns, "samples");
    require_row(fourier, p.order, row);
    for (std::size_t c = 0; c < columns; ++c) {
        p.scalar_in[c] = {samples[4 * c], samples[4 * c + 3]};
        p.spin_in[c] = {samples[4 * c + 1], samples[4 * c + 2]};
    }
    p.forward.transform(p.scalar_in.data(), p.scalar_out.data());
    p.forward.transform(p.spin_in.data(), p.spin_out.data());
    const double scale = 1.0 / p.columns;
    for (int m = 0; m <= p.order; ++m) {
        const Complex unit = scale * std::conj(p.phase[static_cast<std::size_t>(m)]);
        const Complex plus = p.scalar_out[p.bin(m)];
        const Complex minus = std::conj(p.scalar_out[p.bin(-m)]);
        const Complex difference = plus - minus;
        fourier.s0[fourier.scalar_index(row, m)] = 0.5 * (plus + minus) * unit;
        fourier.s3[fourier.scalar_index(row, m)] =
            0.5 * Complex(difference.imag(), -difference.real()) * unit;
        fourier.spin[fourier.spin_index(row, m)] = p.spin_out[p.bin(m)] * unit;
        if (m > 0)
            fourier.spin[fourier.spin_index(row, -m)] =
                p.spin_out[p.bin(-m)] * (scale * p.phase[static_cast<std::size_t>(m)]);
    }
}

void FourierTransform::synthesize(const FourierRows& fourier, int row, std::span<double> samples) {
    Plan& p = *plan_;
    const auto columns = static_cast<std::size_t>(p.columns);
    require_size(samples.size(), 4 * columns, "samples");
    require_row(fourier, p.order, row);
    std::fill(p.scalar_in.begin(), p.scalar_in.end(), Complex());
    std::fill(p.spin_in.begin(), p.spin_in.end(), Complex());
    for (int m = 0; m <= p.order; ++m) {
        const Complex unit = p.phase[static_cast<std::size_t>(m)];
        const Complex s0 = fourier.s0[fourier.scalar_index(row, m)] * unit;
        const Complex s3 = fourier.s3[fourier.scalar_index(row, m)] * unit;
        if (m == 0) {
            p.scalar_in[0] = {s0.real(), s3.real()};
            p.spin_in[0] = fourier.spin[fourier.spin_index(row, 0)];
        } else {
            p.scalar_in[p.bin(m)] = {s0.real() - s3.imag(), s0.imag() + s3.real()};
            p.scalar_in[p.bin(-m)] = {s0.real() + s3.imag(), s3.real() - s0.imag()};
            p.spin_in[p.bin(m)] = fourier.spin[fourier.spin_index(row, m)] * unit;
            p.spin_in[p.bin(-m)] = fourier.spin[fourier.spin_index(row, -m)] * std::conj(unit);
        }
    }
    p.backward.transform(p.scalar_in.data(), p.scalar_out.data());
    p.backward.transform(p.spin_in.data(), p.spin_out.data());
    for (std::size_t c = 0; c < columns; ++c) {
        samples[4 * c] = p.scalar_out[c].real();
        samples[4 * c + 1] = p.spin_out[c].real();
        samples[4 * c + 2] = p.spin_out[c].imag();
        samples[4 * c + 3] = p.scalar_out[c].imag();
    }
}

}  // namespace nicol
