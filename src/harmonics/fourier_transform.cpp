// SPDX-License-Identifier: MIT
// Fourier step of the transform. s0 + i s3 and s1 + i s2 are one complex sequence each, and eight sequences
// of several rows are transformed at once.
#include <cmath>
#include <optional>

#include "harmonics/batch_fft.hpp"
#include "harmonics/low_degrees.hpp"
#include "harmonics/require.hpp"
#include "harmonics/transform.hpp"

namespace nicol {

using Complex = std::complex<double>;

FourierRows::FourierRows(int order_, int rows_) : order(order_), rows(rows_) {
    require_order(order);
    require(rows >= 1 && rows <= kMaxRows,
            "rows is " + std::to_string(rows) + ", expected 1 to " + std::to_string(kMaxRows));
    const auto r = static_cast<std::size_t>(rows);
    const auto n = static_cast<std::size_t>(order) + 1;
    s0.resize(r * n);
    s3.resize(r * n);
    spin.resize(r * (2 * n - 1));
}

struct FourierTransform::Plan {
    /// One sequence of a batch: the scalar or the spin-2 part of a row.
    struct Lane {
        int row;
        bool spin;
    };

    Plan(int order_, int columns_, double phi0)
        : order(order_),
          columns(columns_),
          fft(columns_),
          phase(static_cast<std::size_t>(order_) + 1),
          data(BatchFft::kElement * static_cast<std::size_t>(columns_)) {
        for (int m = 0; m <= order; ++m) phase[static_cast<std::size_t>(m)] = std::polar(1.0, m * phi0);
        if (LowDegrees::suits(order, columns)) low.emplace(order, columns);
    }

    /// Returns the index of degree m in a transform.
    [[nodiscard]] std::size_t bin(int m) const {
        return BatchFft::kElement * static_cast<std::size_t>(m >= 0 ? m : m + columns);
    }
    [[nodiscard]] Complex unit(int m) const { return phase[static_cast<std::size_t>(m)]; }

    /// Clears lanes without a sequence, which would otherwise transform old results and grow without end.
    void clear_unused() {
        for (std::size_t i = 0; i < data.size(); i += BatchFft::kLanes)
            for (std::size_t lane = lanes.size(); lane < BatchFft::kLanes; ++lane) data[i + lane] = 0;
    }

    void load_samples(std::span<const double> samples, const Lane& lane, std::size_t at) {
        const auto n = static_cast<std::size_t>(columns);
        const double* row = &samples[4 * n * static_cast<std::size_t>(lane.row)];
        double* to = data.data() + at;
        for (std::size_t c = 0; c < n; ++c, row += 4, to += BatchFft::kElement) {
            to[0] = lane.spin ? row[1] : row[0];
            to[BatchFft::kLanes] = lane.spin ? row[2] : row[3];
        }
    }

    void store_samples(const double* from, const Lane& lane, std::size_t at,
                       std::span<double> samples) const {
        const auto n = static_cast<std::size_t>(columns);
        double* row = &samples[4 * n * static_cast<std::size_t>(lane.row)];
        from += at;
        for (std::size_t c = 0; c < n; ++c, row += 4, from += BatchFft::kElement) {
            (lane.spin ? row[1] : row[0]) = from[BatchFft::kLanes];
            (lane.spin ? row[2] : row[3]) = from[0];
        }
    }

    /// Stores s0, s3 and s1 + i s2 from sums with cosines and sines.
    void store_low_degrees(std::span<const double> sums, FourierRows& out, int row) const {
        const double scale = 1.0 / columns;
        for (int m = 0; m <= order; ++m) {
            const double* c = &sums[8 * static_cast<std::size_t>(m)];
            const double* s = c + 4;
            const Complex turn = scale * std::conj(unit(m));
            out.s0[out.scalar_index(row, m)] = Complex(c[0], -s[0]) * turn;
            out.s3[out.scalar_index(row, m)] = Complex(c[3], -s[3]) * turn;
            out.spin[out.spin_index(row, -m)] = Complex(c[1] - s[2], c[2] + s[1]) * std::conj(turn);
            out.spin[out.spin_index(row, m)] = Complex(c[1] + s[2], c[2] - s[1]) * turn;
        }
    }

    void store_coefficients(const double* from, const Lane& lane, std::size_t at, FourierRows& out,
                            int row) const {
        const double scale = 1.0 / columns;
        from += at;
        for (int m = 0; m <= order; ++m) {
            const double* p = from + bin(m);
            const double* n = from + bin(-m);
            const Complex plus = scale * Complex(p[0], p[BatchFft::kLanes]);
            const Complex minus = scale * Complex(n[0], n[BatchFft::kLanes]);
            if (lane.spin) {
                out.spin[out.spin_index(row, -m)] = minus * unit(m);
                out.spin[out.spin_index(row, m)] = plus * std::conj(unit(m));
            } else {
                const Complex sum = plus + std::conj(minus);
                const Complex difference = plus - std::conj(minus);
                out.s0[out.scalar_index(row, m)] = 0.5 * sum * std::conj(unit(m));
                out.s3[out.scalar_index(row, m)] =
                    0.5 * Complex(difference.imag(), -difference.real()) * std::conj(unit(m));
            }
        }
    }

    /// Loads a row with real and imaginary part exchanged, so that the transform is the inverse transform.
    void load_coefficients(const FourierRows& in, const Lane& lane, std::size_t at, int row) {
        double* to = data.data() + at;
        for (std::size_t i = 0; i < data.size(); i += BatchFft::kElement)
            to[i] = to[i + BatchFft::kLanes] = 0;
        const auto put = [&](int m, Complex value) {
            to[bin(m)] = value.imag();
            to[bin(m) + BatchFft::kLanes] = value.real();
        };
        for (int m = 0; m <= order; ++m) {
            if (lane.spin) {
                put(-m, in.spin[in.spin_index(row, -m)] * std::conj(unit(m)));
                put(m, in.spin[in.spin_index(row, m)] * unit(m));
                continue;
            }
            const Complex s0 = in.s0[in.scalar_index(row, m)] * unit(m);
            const Complex s3 = in.s3[in.scalar_index(row, m)] * unit(m);
            if (m == 0) {
                put(0, {s0.real(), s3.real()});
            } else {
                put(m, {s0.real() - s3.imag(), s0.imag() + s3.real()});
                put(-m, {s0.real() + s3.imag(), s3.real() - s0.imag()});
            }
        }
    }

    int order;
    int columns;
    BatchFft fft;
    std::optional<LowDegrees> low;
    std::vector<Complex> phase;  // exp(i m phi0)
    std::vector<double> data;
    std::vector<Lane> lanes;
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

/// Returns the number of rows in `samples`.
int count_rows(std::size_t samples, int columns, const FourierRows& fourier, int order, int first_row) {
    const std::size_t row = 4 * static_cast<std::size_t>(columns);
    require(samples > 0 && samples % row == 0, "samples holds " + std::to_string(samples) +
                                                   " values, expected a multiple of " + std::to_string(row));
    require(fourier.order == order,
            "fourier has order " + std::to_string(fourier.order) + ", expected " + std::to_string(order));
    const std::size_t count = samples / row;
    require(first_row >= 0 && first_row < fourier.rows &&
                count <= static_cast<std::size_t>(fourier.rows - first_row),
            "rows from " + std::to_string(first_row) + " on do not fit into the " +
                std::to_string(fourier.rows) + " of fourier");
    return static_cast<int>(count);
}

bool has_samples(std::span<const double> samples, std::size_t a, std::size_t b) {
    for (std::size_t i = 0; i < samples.size(); i += 4)
        if (samples[i + a] != 0 || samples[i + b] != 0) return true;
    return false;
}

bool any(std::span<const Complex> values) {
    for (const Complex& value : values)
        if (value != Complex()) return true;
    return false;
}

}  // namespace

void FourierTransform::analyze(std::span<const double> samples, FourierRows& fourier, int first_row) {
    Plan& p = *plan_;
    const int rows = count_rows(samples.size(), p.columns, fourier, p.order, first_row);
    const auto row_size = 4 * static_cast<std::size_t>(p.columns);
    if (p.low) {
        for (int row = 0; row < rows; ++row)
            p.store_low_degrees(
                p.low->sums(samples.subspan(row_size * static_cast<std::size_t>(row), row_size)), fourier,
                first_row + row);
        return;
    }
    p.lanes.clear();
    for (int row = 0; row < rows; ++row) {
        const auto one = samples.subspan(row_size * static_cast<std::size_t>(row), row_size);
        const int to = first_row + row;
        if (has_samples(one, 0, 3)) {
            p.lanes.push_back({row, false});
        } else {
            std::fill_n(&fourier.s0[fourier.scalar_index(to, 0)], p.order + 1, Complex());
            std::fill_n(&fourier.s3[fourier.scalar_index(to, 0)], p.order + 1, Complex());
        }
        if (has_samples(one, 1, 2)) {
            p.lanes.push_back({row, true});
        } else {
            std::fill_n(&fourier.spin[fourier.spin_index(to, -p.order)], 2 * p.order + 1, Complex());
        }
        if (p.lanes.size() >= BatchFft::kLanes - 1 || row + 1 == rows) {
            if (p.lanes.empty()) continue;
            p.clear_unused();
            for (std::size_t i = 0; i < p.lanes.size(); ++i) p.load_samples(samples, p.lanes[i], i);
            const double* out = p.fft.forward(p.data.data());
            for (std::size_t i = 0; i < p.lanes.size(); ++i)
                p.store_coefficients(out, p.lanes[i], i, fourier, first_row + p.lanes[i].row);
            p.lanes.clear();
        }
    }
}

void FourierTransform::synthesize(const FourierRows& fourier, int first_row, std::span<double> samples) {
    Plan& p = *plan_;
    const int rows = count_rows(samples.size(), p.columns, fourier, p.order, first_row);
    const auto row_size = 4 * static_cast<std::size_t>(p.columns);
    const auto degrees = static_cast<std::size_t>(p.order) + 1;
    p.lanes.clear();
    for (int row = 0; row < rows; ++row) {
        const int from = first_row + row;
        const auto clear = [&](std::size_t a, std::size_t b) {
            double* to = &samples[row_size * static_cast<std::size_t>(row)];
            for (std::size_t i = 0; i < row_size; i += 4) to[i + a] = to[i + b] = 0;
        };
        const bool scalar = any({&fourier.s0[fourier.scalar_index(from, 0)], degrees}) ||
                            any({&fourier.s3[fourier.scalar_index(from, 0)], degrees});
        const bool spin = any({&fourier.spin[fourier.spin_index(from, -p.order)], 2 * degrees - 1});
        if (scalar)
            p.lanes.push_back({row, false});
        else
            clear(0, 3);
        if (spin)
            p.lanes.push_back({row, true});
        else
            clear(1, 2);
        if (p.lanes.size() >= BatchFft::kLanes - 1 || row + 1 == rows) {
            if (p.lanes.empty()) continue;
            p.clear_unused();
            for (std::size_t i = 0; i < p.lanes.size(); ++i)
                p.load_coefficients(fourier, p.lanes[i], i, first_row + p.lanes[i].row);
            const double* out = p.fft.forward(p.data.data());
            for (std::size_t i = 0; i < p.lanes.size(); ++i) p.store_samples(out, p.lanes[i], i, samples);
            p.lanes.clear();
        }
    }
}

}  // namespace nicol
