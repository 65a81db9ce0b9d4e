// SPDX-License-Identifier: MIT
// By FFT, or directly where the FFT would be slower.
#include "light/degree_sums.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nicol {
namespace {

using Complex = std::complex<double>;

int largest_prime_factor(int n) {
    int largest = 1;
    for (int p = 2; p * p <= n; ++p) {
        while (n % p == 0) {
            largest = p;
            n /= p;
        }
    }
    return n > 1 ? n : largest;
}

}  // namespace

DegreeSums::DegreeSums(int order, int columns, double phi0)
    : order_(order),
      columns_(columns),
      // A prime factor p costs the FFT p operations a column, a direct sum 2 order + 1.
      direct_(largest_prime_factor(columns) > std::max(2 * order + 1, 32)),
      fft_(direct_ ? 1 : static_cast<std::size_t>(columns), false),
      bins_(static_cast<std::size_t>(columns)) {
    for (int m = -order; m <= order; ++m) phase_.push_back(std::polar(1.0, -m * phi0));
    if (!direct_) return;
    for (int k = 0; k < columns; ++k)
        bins_[static_cast<std::size_t>(k)] = std::polar(1.0, -2 * std::numbers::pi * k / columns);
}

void DegreeSums::operator()(std::span<const Complex> row, std::span<Complex> sums) {
    if (!direct_) fft_.transform(row.data(), bins_.data());
    for (int m = -order_; m <= order_; ++m) {
        const auto i = static_cast<std::size_t>(m + order_);
        const auto bin = static_cast<std::size_t>((m % columns_ + columns_) % columns_);
        if (!direct_) {
            sums[i] = phase_[i] * bins_[bin];
            continue;
        }
        Complex sum = 0;
        std::size_t root = 0;
        for (const Complex& z : row) {
            sum += z * bins_[root];
            root += bin;
            if (root >= bins_.size()) root -= bins_.size();
        }
        sums[i] = phase_[i] * sum;
    }
}

}  // namespace nicol
