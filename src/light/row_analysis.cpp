// SPDX-License-Identifier: MIT
// Fourier coefficients of rows: a few degrees directly, many by FFT.
#include "light/row_analysis.hpp"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "light/degree_sums.hpp"
#include "light/folded_sums.hpp"

namespace nicol {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

class RowAnalysis {
public:
    RowAnalysis(const EquirectPixels& pixels, int order)
        : pixels_(pixels), order_(order), factor_(static_cast<std::size_t>(2 * order) + 1) {
        // A row linear between its pixels is their comb convolved with a hat, whose transform is sinc^2.
        for (int m = -order; m <= order; ++m) {
            const double x = pi * m / pixels.width;
            const double sinc = m == 0 ? 1 : std::sin(x) / x;
            factor_[static_cast<std::size_t>(m + order)] = sinc * sinc / pixels.width;
        }
    }

    [[nodiscard]] FourierRows run(int channel) const {
        FourierRows result(order_, pixels_.height);
        if (FoldedSums::suits(order_, pixels_.width))
            run_folded(channel, result);
        else
            run_transformed(channel, result);
        return result;
    }

private:
    void run_folded(int channel, FourierRows& result) const {
        const FoldedSums prototype(order_, pixels_.width);
        tbb::enumerable_thread_specific<FoldedSums> workers(prototype);
        if (pixels_.components == 4) {
            tbb::parallel_for(0, pixels_.height, [&](int row) {
                const float* start = first(channel, {row, 0});
                const auto sums = workers.local()({{start, start + 1, start + 2, start + 3}, 4});
                store_folded(sums, 0, result.s0, row);
                store_folded(sums, 3, result.s3, row);
                store_folded_spin(sums, result, row);
            });
            return;
        }
        tbb::parallel_for(0, (pixels_.height + 3) / 4, [&](int group) {
            std::array<int, 4> rows{};
            std::array<const float*, 4> starts{};
            for (std::size_t k = 0; k < 4; ++k) {
                rows[k] = std::min(4 * group + static_cast<int>(k), pixels_.height - 1);
                starts[k] = first(channel, {rows[k], 0});
            }
            const auto sums = workers.local()({starts, 1});
            for (std::size_t k = 0; k < 4; ++k) store_folded(sums, k, result.s0, rows[k]);
        });
    }

    /// phi = pi - a, so exp(-i m phi) = (-1)^m exp(i m a).
    [[nodiscard]] double folded_factor(std::size_t m) const {
        const double factor = factor_[static_cast<std::size_t>(order_) + m];
        return m % 2 == 0 ? factor : -factor;
    }

    void store_folded(std::span<const double> sums, std::size_t k, std::vector<Complex>& to, int row) const {
        const auto n = static_cast<std::size_t>(order_);
        for (std::size_t m = 0; m <= n; ++m)
            to[static_cast<std::size_t>(row) * (n + 1) + m] =
                folded_factor(m) * Complex(sums[8 * m + k], sums[8 * m + 4 + k]);
    }

    /// From the picture's frame to the theta-phi frame: a quarter turn, the sign of s1 + i s2.
    void store_folded_spin(std::span<const double> sums, FourierRows& result, int row) const {
        for (int m = 0; m <= order_; ++m) {
            const double* s = &sums[8 * static_cast<std::size_t>(m)];
            const double factor = -folded_factor(static_cast<std::size_t>(m));
            result.spin[result.spin_index(row, m)] = factor * Complex(s[1] - s[6], s[2] + s[5]);
            result.spin[result.spin_index(row, -m)] = factor * Complex(s[1] + s[6], s[2] - s[5]);
        }
    }

    void run_transformed(int channel, FourierRows& result) const {
        // phi = pi - 2 pi u falls with the column, so the pixels are taken from the right.
        tbb::enumerable_thread_specific<Worker> workers([&] {
            return Worker{DegreeSums(order_, pixels_.width, pi / pixels_.width - pi),
                          std::vector<Complex>(static_cast<std::size_t>(pixels_.width)),
                          std::vector<Complex>(factor_.size())};
        });
        if (pixels_.components == 4) {
            tbb::parallel_for(0, pixels_.height, [&](int row) {
                Worker& worker = workers.local();
                load(worker, channel, {row, 0}, {row, 3}, 1);
                store_real(worker, result.s0, row);
                store_imaginary(worker, result.s3, row);
                load(worker, channel, {row, 1}, {row, 2}, -1);
                std::ranges::copy(worker.sums, result.spin.begin() + static_cast<std::ptrdiff_t>(
                                                                         result.spin_index(row, -order_)));
            });
            return;
        }
        // Two real rows are one complex row.
        tbb::parallel_for(0, (pixels_.height + 1) / 2, [&](int pair) {
            Worker& worker = workers.local();
            const int second = std::min(2 * pair + 1, pixels_.height - 1);
            load(worker, channel, {2 * pair, 0}, {second, 0}, 1);
            store_real(worker, result.s0, 2 * pair);
            store_imaginary(worker, result.s0, second);
        });
    }

    struct Worker {
        DegreeSums transform;
        std::vector<Complex> samples;
        std::vector<Complex> sums;
    };
    struct Source {
        int row;
        std::size_t component;
    };

    [[nodiscard]] const float* first(int channel, Source source) const {
        const int row = channel * pixels_.height + (pixels_.height - 1 - source.row);
        return pixels_.values.data() +
               static_cast<std::size_t>(row) * static_cast<std::size_t>(pixels_.width) *
                   static_cast<std::size_t>(pixels_.components) +
               source.component;
    }

    /// The Fourier coefficients of sign * (real + i imaginary).
    void load(Worker& worker, int channel, Source real, Source imaginary, double sign) const {
        const auto components = static_cast<std::size_t>(pixels_.components);
        const float* a = first(channel, real);
        const float* b = first(channel, imaginary);
        const std::size_t width = worker.samples.size();
        for (std::size_t i = 0; i < width; ++i) {
            const std::size_t at = (width - 1 - i) * components;
            worker.samples[i] = sign * Complex(a[at], b[at]);
        }
        worker.transform(worker.samples, worker.sums);
        for (std::size_t i = 0; i < factor_.size(); ++i) worker.sums[i] *= factor_[i];
    }

    /// The coefficients m >= 0 of the real part of what was loaded.
    void store_real(const Worker& worker, std::vector<Complex>& to, int row) const {
        const auto n = static_cast<std::size_t>(order_);
        for (std::size_t m = 0; m <= n; ++m)
            to[static_cast<std::size_t>(row) * (n + 1) + m] =
                0.5 * (worker.sums[n + m] + std::conj(worker.sums[n - m]));
    }

    void store_imaginary(const Worker& worker, std::vector<Complex>& to, int row) const {
        const auto n = static_cast<std::size_t>(order_);
        for (std::size_t m = 0; m <= n; ++m)
            to[static_cast<std::size_t>(row) * (n + 1) + m] =
                Complex(0, -0.5) * (worker.sums[n + m] - std::conj(worker.sums[n - m]));
    }

    const EquirectPixels& pixels_;
    int order_;
    std::vector<double> factor_;
};

}  // namespace

FourierRows analyze_rows(const EquirectPixels& pixels, int channel, int order) {
    return RowAnalysis(pixels, order).run(channel);
}

}  // namespace nicol
