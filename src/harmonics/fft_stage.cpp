// SPDX-License-Identifier: MIT
#include "harmonics/fft_stage.hpp"

#include "simd/dispatch.hpp"
#include "simd/double_vectors.hpp"

namespace nicol {
namespace {

// Eight complex numbers, in vectors of Width.
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

// The sums over `P` inputs for its small transform, P known: x_j = sum_r a_r root^(j r).
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
        // Odd: pairs r and P - r share their products with the cosines and sines.
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

// The same for any odd factor up to kLargestOdd.
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

}  // namespace

void fft_stage(const double* in, double* out, int factor, int left, int stride, const double* twiddles,
               const double* roots) {
    dispatch<any_stage<2>, any_stage<4>, any_stage<8>>(in, out, factor, left, stride, twiddles, roots);
}

}  // namespace nicol
