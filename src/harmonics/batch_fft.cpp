// SPDX-License-Identifier: MIT
#include "harmonics/batch_fft.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "harmonics/fft_stage.hpp"

namespace nicol {
namespace {

using Complex = std::complex<double>;

/// Above this prime factor the chirp is cheaper than the direct sum; at most what fft_stage() takes.
constexpr int kLargestFactor = 61;

/// exp(-2 pi i k / n), with k reduced first.
Complex root_of_unity(long long k, long long n) {
    return std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k % n) / static_cast<double>(n));
}

std::vector<int> factors_of(int n) {
    std::vector<int> out;
    for (const int p : {4, 2, 3, 5})
        for (; n % p == 0; n /= p) out.push_back(p);
    for (int p = 7; p <= n / p; p += 2)
        for (; n % p == 0; n /= p) out.push_back(p);
    if (n > 1) out.push_back(n);
    return out;
}

/// The smallest product of 2, 3 and 5 that is not below `least`.
int smooth_length(int least) {
    int best = 1;
    while (best < least) best *= 2;
    for (int five = 1; five < best; five *= 5)
        for (int three = five; three < best; three *= 3) {
            int n = three;
            while (n < least) n *= 2;
            best = std::min(best, n);
        }
    return best;
}

/// The length itself, or the one a chirp needs.
int working_length(int length) {
    const std::vector<int> factors = factors_of(length);
    const bool direct = std::ranges::all_of(factors, [](int p) { return p <= kLargestFactor; });
    return direct ? length : smooth_length(2 * length - 1);
}

void multiply_elements(double* data, const std::vector<Complex>& by) {
    for (std::size_t i = 0; i < by.size(); ++i) {
        double* re = data + BatchFft::kElement * i;
        double* im = re + BatchFft::kLanes;
        for (std::size_t lane = 0; lane < BatchFft::kLanes; ++lane) {
            const double r = re[lane] * by[i].real() - im[lane] * by[i].imag();
            im[lane] = re[lane] * by[i].imag() + im[lane] * by[i].real();
            re[lane] = r;
        }
    }
}

}  // namespace

BatchFft::Factorised::Factorised(int n) : length(n), factors(factors_of(n)) {
    int left = n;
    for (const int p : factors) {
        std::vector<Complex> stage;
        for (int k = 0; k < left / p; ++k)
            for (int j = 1; j < p; ++j) stage.push_back(root_of_unity(static_cast<long long>(k) * j, left));
        twiddles.push_back(std::move(stage));
        std::vector<Complex> unit;
        unit.reserve(static_cast<std::size_t>(p));
        for (int j = 0; j < p; ++j) unit.push_back(root_of_unity(j, p));
        roots.push_back(std::move(unit));
        left /= p;
    }
}

double* BatchFft::Factorised::run(double* a, double* b) const {
    int left = length;
    int stride = 1;
    for (std::size_t stage = 0; stage < factors.size(); ++stage) {
        const int p = factors[stage];
        left /= p;
        fft_stage(a, b, p, left, stride, reinterpret_cast<const double*>(twiddles[stage].data()),
                  reinterpret_cast<const double*>(roots[stage].data()));
        stride *= p;
        std::swap(a, b);
    }
    return a;
}

BatchFft::BatchFft(int length) : direct_(working_length(length)) {
    const auto n = static_cast<std::size_t>(length);
    if (direct_.length == length) {
        other_.resize(kElement * n);
        return;
    }
    const auto m = static_cast<std::size_t>(direct_.length);
    for (long long i = 0; i < length; ++i) chirp_.push_back(root_of_unity(i * i, 2LL * length));
    long_a_.assign(kElement * m, 0.0);
    long_b_.resize(kElement * m);
    for (std::size_t i = 0; i < n; ++i)
        for (const std::size_t at : {i, (m - i) % m}) {
            long_a_[kElement * at] = chirp_[i].real();
            long_a_[kElement * at + kLanes] = -chirp_[i].imag();
        }
    const double* transform = direct_.run(long_a_.data(), long_b_.data());
    for (std::size_t i = 0; i < m; ++i)
        chirp_transform_.push_back(Complex(transform[kElement * i], transform[kElement * i + kLanes]) /
                                   static_cast<double>(m));
}

const double* BatchFft::forward(double* data) {
    if (chirp_.empty()) return direct_.run(data, other_.data());
    const std::size_t n = kElement * chirp_.size();
    multiply_elements(data, chirp_);
    std::copy_n(data, n, long_a_.begin());
    std::fill(long_a_.begin() + static_cast<std::ptrdiff_t>(n), long_a_.end(), 0.0);
    double* result = direct_.run(long_a_.data(), long_b_.data());
    multiply_elements(result, chirp_transform_);
    // The transform back is the transform with real and imaginary parts exchanged, before and after.
    const auto exchange = [](double* values, std::size_t size) {
        for (std::size_t i = 0; i < size; i += kElement)
            std::swap_ranges(values + i, values + i + kLanes, values + i + kLanes);
    };
    exchange(result, long_a_.size());
    result = direct_.run(result, result == long_a_.data() ? long_b_.data() : long_a_.data());
    exchange(result, n);
    multiply_elements(result, chirp_);
    return result;
}

}  // namespace nicol
