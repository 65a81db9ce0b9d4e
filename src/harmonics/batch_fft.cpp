// SPDX-License-Identifier: MIT
#include "harmonics/batch_fft.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "simd/dispatch.hpp"
#include "simd/double_vectors.hpp"

namespace nicol {
namespace {

// Eight complex numbers in vectors of Width.
template <int Width>
struct Element {
    static constexpr int kParts = 8 / Width;
    using Vector = typename DoubleVectors<Width>::Vector;

    Vector re[kParts], im[kParts];
};

template <int Width>
[[gnu::always_inline]] inline void load(Element<Width>& e, const double* p) {
    for (int v = 0; v < Element<Width>::kParts; ++v) {
        load_vector(p + v * Width, e.re[v]);
        load_vector(p + 8 + v * Width, e.im[v]);
    }
}

template <int Width>
[[gnu::always_inline]] inline void store(const Element<Width>& e, double* p) {
    for (int v = 0; v < Element<Width>::kParts; ++v) {
        store_vector(p + v * Width, e.re[v]);
        store_vector(p + 8 + v * Width, e.im[v]);
    }
}

template <int Width>
[[gnu::always_inline]] inline void store_rotated(const Element<Width>& e, const double* twiddle, double* p) {
    for (int v = 0; v < Element<Width>::kParts; ++v) {
        store_vector(p + v * Width, e.re[v] * twiddle[0] - e.im[v] * twiddle[1]);
        store_vector(p + 8 + v * Width, e.re[v] * twiddle[1] + e.im[v] * twiddle[0]);
    }
}

// Computes the small transform of P inputs, with P known at compile time: x_j = sum_r a_r root^(j r).
template <int P, int Width>
[[gnu::always_inline]] inline void small_transform(const Element<Width>* a, const double* roots,
                                                   Element<Width>* x) {
    using Vector = typename Element<Width>::Vector;
    if constexpr (P == 2) {
        for (int v = 0; v < Element<Width>::kParts; ++v) {
            x[0].re[v] = a[0].re[v] + a[1].re[v];
            x[0].im[v] = a[0].im[v] + a[1].im[v];
            x[1].re[v] = a[0].re[v] - a[1].re[v];
            x[1].im[v] = a[0].im[v] - a[1].im[v];
        }
    } else if constexpr (P == 4) {
        for (int v = 0; v < Element<Width>::kParts; ++v) {
            const Vector sum_re = a[0].re[v] + a[2].re[v], sum_im = a[0].im[v] + a[2].im[v];
            const Vector dif_re = a[0].re[v] - a[2].re[v], dif_im = a[0].im[v] - a[2].im[v];
            const Vector odd_re = a[1].re[v] + a[3].re[v], odd_im = a[1].im[v] + a[3].im[v];
            const Vector gap_re = a[1].re[v] - a[3].re[v], gap_im = a[1].im[v] - a[3].im[v];
            x[0].re[v] = sum_re + odd_re;
            x[0].im[v] = sum_im + odd_im;
            x[1].re[v] = dif_re + gap_im;
            x[1].im[v] = dif_im - gap_re;
            x[2].re[v] = sum_re - odd_re;
            x[2].im[v] = sum_im - odd_im;
            x[3].re[v] = dif_re - gap_im;
            x[3].im[v] = dif_im + gap_re;
        }
    } else {
        // P is odd: pairs r and P - r share their products with the cosines and sines.
        for (int v = 0; v < Element<Width>::kParts; ++v) {
            Vector sum_re[P / 2 + 1], sum_im[P / 2 + 1], gap_re[P / 2 + 1], gap_im[P / 2 + 1];
            x[0].re[v] = a[0].re[v];
            x[0].im[v] = a[0].im[v];
            for (int r = 1; r <= P / 2; ++r) {
                sum_re[r] = a[r].re[v] + a[P - r].re[v];
                sum_im[r] = a[r].im[v] + a[P - r].im[v];
                gap_re[r] = a[r].re[v] - a[P - r].re[v];
                gap_im[r] = a[r].im[v] - a[P - r].im[v];
                x[0].re[v] += sum_re[r];
                x[0].im[v] += sum_im[r];
            }
            for (int j = 1; j <= P / 2; ++j) {
                Vector even_re = a[0].re[v], even_im = a[0].im[v];
                Vector odd_re{}, odd_im{};
                for (int r = 1; r <= P / 2; ++r) {
                    const double c = roots[2 * (j * r % P)];
                    const double s = roots[2 * (j * r % P) + 1];
                    even_re += c * sum_re[r];
                    even_im += c * sum_im[r];
                    odd_re -= s * gap_im[r];
                    odd_im += s * gap_re[r];
                }
                x[j].re[v] = even_re + odd_re;
                x[j].im[v] = even_im + odd_im;
                x[P - j].re[v] = even_re - odd_re;
                x[P - j].im[v] = even_im - odd_im;
            }
        }
    }
}

template <int P, int Width>
[[gnu::always_inline]] inline void stage(const double* in, double* out, int left, int stride,
                                         const double* twiddles, const double* roots) {
    const long step = 16L * stride;
    for (int k = 0; k < left; ++k) {
        const double* twiddle = twiddles + 2 * k * (P - 1);
        for (int q = 0; q < stride; ++q) {
            Element<Width> a[P], x[P];
            for (int j = 0; j < P; ++j) load(a[j], in + 16L * q + step * (k + left * j));
            small_transform<P, Width>(a, roots, x);
            double* to = out + 16L * q + step * P * k;
            store(x[0], to);
            for (int j = 1; j < P; ++j) store_rotated(x[j], twiddle + 2 * (j - 1), to + step * j);
        }
    }
}

constexpr int kLargestOdd = 63;

// Computes one stage for any odd factor up to kLargestOdd, which is not known at compile time.
template <int Width>
[[gnu::always_inline]] inline void odd_stage(const double* in, double* out, int factor, int left, int stride,
                                             const double* twiddles, const double* roots) {
    const long step = 16L * stride;
    const int half = factor / 2;
    Element<Width> sum[kLargestOdd / 2 + 1], gap[kLargestOdd / 2 + 1];
    for (int k = 0; k < left; ++k) {
        const double* twiddle = twiddles + 2 * k * (factor - 1);
        for (int q = 0; q < stride; ++q) {
            const double* from = in + 16L * q + step * k;
            double* to = out + 16L * q + step * factor * k;
            Element<Width> first;
            load(first, from);
            Element<Width> total = first;
            for (int r = 1; r <= half; ++r) {
                Element<Width> a, b;
                load(a, from + step * left * r);
                load(b, from + step * left * (factor - r));
                for (int v = 0; v < Element<Width>::kParts; ++v) {
                    sum[r].re[v] = a.re[v] + b.re[v];
                    sum[r].im[v] = a.im[v] + b.im[v];
                    gap[r].re[v] = a.re[v] - b.re[v];
                    gap[r].im[v] = a.im[v] - b.im[v];
                    total.re[v] += sum[r].re[v];
                    total.im[v] += sum[r].im[v];
                }
            }
            store(total, to);
            for (int j = 1; j <= half; ++j) {
                Element<Width> even = first, odd{};
                for (int r = 1, i = j; r <= half; ++r, i += i + j < factor ? j : j - factor) {
                    const double c = roots[2 * i];
                    const double s = roots[2 * i + 1];
                    for (int v = 0; v < Element<Width>::kParts; ++v) {
                        even.re[v] += c * sum[r].re[v];
                        even.im[v] += c * sum[r].im[v];
                        odd.re[v] -= s * gap[r].im[v];
                        odd.im[v] += s * gap[r].re[v];
                    }
                }
                Element<Width> x, y;
                for (int v = 0; v < Element<Width>::kParts; ++v) {
                    x.re[v] = even.re[v] + odd.re[v];
                    x.im[v] = even.im[v] + odd.im[v];
                    y.re[v] = even.re[v] - odd.re[v];
                    y.im[v] = even.im[v] - odd.im[v];
                }
                store_rotated(x, twiddle + 2 * (j - 1), to + step * j);
                store_rotated(y, twiddle + 2 * (factor - j - 1), to + step * (factor - j));
            }
        }
    }
}

template <int Width>
[[gnu::always_inline]] inline void any_stage(const double* in, double* out, int factor, int left, int stride,
                                             const double* twiddles, const double* roots) {
    switch (factor) {
        case 2:
            stage<2, Width>(in, out, left, stride, twiddles, roots);
            break;
        case 3:
            stage<3, Width>(in, out, left, stride, twiddles, roots);
            break;
        case 4:
            stage<4, Width>(in, out, left, stride, twiddles, roots);
            break;
        case 5:
            stage<5, Width>(in, out, left, stride, twiddles, roots);
            break;
        case 7:
            stage<7, Width>(in, out, left, stride, twiddles, roots);
            break;
        default:
            odd_stage<Width>(in, out, factor, left, stride, twiddles, roots);
            break;
    }
}

/// Computes one stage of a Fourier transform of eight sequences (layout of BatchFft): radix `factor`, `left`
/// groups, `stride` elements in each. Twiddles [group][1..factor-1] and roots of unity are pairs (re, im).
/// Factors other than 2, 3, 4, 5 and 7 must be odd and at most 63.
void fft_stage(const double* in, double* out, int factor, int left, int stride, const double* twiddles,
               const double* roots) {
    dispatch<any_stage<2>, any_stage<4>, any_stage<8>>(in, out, factor, left, stride, twiddles, roots);
}

using Complex = std::complex<double>;

/// Largest prime factor for which the direct sum is cheaper than the chirp; at most the limit of fft_stage().
constexpr int kLargestFactor = 61;

/// Returns exp(-2 pi i k / n), with k reduced first.
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

/// Returns the smallest product of 2, 3 and 5 that is not below `least`.
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

/// Returns the length itself, or the longer length that a chirp needs.
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
    // The inverse transform is the transform with real and imaginary parts exchanged before and after.
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
