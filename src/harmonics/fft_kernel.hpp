// SPDX-License-Identifier: MIT
// Fourier stages and small products over vectors; part of vector_kernel_impl.hpp.
#pragma once

#include "harmonics/vectors.hpp"

namespace nicol {
namespace {

constexpr int kParts = 8 / kLanes;  // vectors in eight lanes

/// Eight complex numbers.
struct Element {
    Vector re[kParts], im[kParts];
};

inline __attribute__((always_inline)) void load(Element& e, const double* p) {
    for (int v = 0; v < kParts; ++v) {
        e.re[v] = at(p + v * kLanes);
        e.im[v] = at(p + 8 + v * kLanes);
    }
}

inline __attribute__((always_inline)) void store(const Element& e, double* p) {
    for (int v = 0; v < kParts; ++v) {
        at(p + v * kLanes) = e.re[v];
        at(p + 8 + v * kLanes) = e.im[v];
    }
}

inline __attribute__((always_inline)) void store_rotated(const Element& e, const double* turn, double* p) {
    for (int v = 0; v < kParts; ++v) {
        at(p + v * kLanes) = e.re[v] * turn[0] - e.im[v] * turn[1];
        at(p + 8 + v * kLanes) = e.re[v] * turn[1] + e.im[v] * turn[0];
    }
}

/// The sums over `P` inputs for its small transform, P known: x_j = sum_r a_r root^(j r).
template <int P>
inline __attribute__((always_inline)) void small_transform(const Element* a, const double* roots,
                                                           Element* x) {
    if constexpr (P == 2) {
        for (int v = 0; v < kParts; ++v) {
            x[0].re[v] = a[0].re[v] + a[1].re[v];
            x[0].im[v] = a[0].im[v] + a[1].im[v];
            x[1].re[v] = a[0].re[v] - a[1].re[v];
            x[1].im[v] = a[0].im[v] - a[1].im[v];
        }
    } else if constexpr (P == 4) {
        for (int v = 0; v < kParts; ++v) {
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
        for (int v = 0; v < kParts; ++v) {
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
                Vector odd_re = Vector{}, odd_im = Vector{};
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

template <int P>
void stage(const double* in, double* out, int left, int stride, const double* twiddles, const double* roots) {
    const long step = 16L * stride;
    for (int k = 0; k < left; ++k) {
        const double* turn = twiddles + 2 * k * (P - 1);
        for (int q = 0; q < stride; ++q) {
            Element a[P], x[P];
            for (int j = 0; j < P; ++j) load(a[j], in + 16L * q + step * (k + left * j));
            small_transform<P>(a, roots, x);
            double* to = out + 16L * q + step * P * k;
            store(x[0], to);
            for (int j = 1; j < P; ++j) store_rotated(x[j], turn + 2 * (j - 1), to + step * j);
        }
    }
}

constexpr int kLargestOdd = 63;

/// The same for any odd factor up to kLargestOdd.
void odd_stage(const double* in, double* out, int factor, int left, int stride, const double* twiddles,
               const double* roots) {
    const long step = 16L * stride;
    const int half = factor / 2;
    Element sum[kLargestOdd / 2 + 1], gap[kLargestOdd / 2 + 1];
    for (int k = 0; k < left; ++k) {
        const double* turn = twiddles + 2 * k * (factor - 1);
        for (int q = 0; q < stride; ++q) {
            const double* from = in + 16L * q + step * k;
            double* to = out + 16L * q + step * factor * k;
            Element first;
            load(first, from);
            Element total = first;
            for (int r = 1; r <= half; ++r) {
                Element a, b;
                load(a, from + step * left * r);
                load(b, from + step * left * (factor - r));
                for (int v = 0; v < kParts; ++v) {
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
                Element even = first, odd{};
                for (int r = 1, i = j; r <= half; ++r, i += i + j < factor ? j : j - factor) {
                    const double c = roots[2 * i];
                    const double s = roots[2 * i + 1];
                    for (int v = 0; v < kParts; ++v) {
                        even.re[v] += c * sum[r].re[v];
                        even.im[v] += c * sum[r].im[v];
                        odd.re[v] -= s * gap[r].im[v];
                        odd.im[v] += s * gap[r].re[v];
                    }
                }
                Element x, y;
                for (int v = 0; v < kParts; ++v) {
                    x.re[v] = even.re[v] + odd.re[v];
                    x.im[v] = even.im[v] + odd.im[v];
                    y.re[v] = even.re[v] - odd.re[v];
                    y.im[v] = even.im[v] - odd.im[v];
                }
                store_rotated(x, turn + 2 * (j - 1), to + step * j);
                store_rotated(y, turn + 2 * (factor - j - 1), to + step * (factor - j));
            }
        }
    }
}

void fft_stage(const double* in, double* out, int factor, int left, int stride, const double* twiddles,
               const double* roots) {
    switch (factor) {
        case 2:
            stage<2>(in, out, left, stride, twiddles, roots);
            break;
        case 3:
            stage<3>(in, out, left, stride, twiddles, roots);
            break;
        case 4:
            stage<4>(in, out, left, stride, twiddles, roots);
            break;
        case 5:
            stage<5>(in, out, left, stride, twiddles, roots);
            break;
        case 7:
            stage<7>(in, out, left, stride, twiddles, roots);
            break;
        default:
            odd_stage(in, out, factor, left, stride, twiddles, roots);
            break;
    }
}

typedef double Four __attribute__((vector_size(32)));
typedef double FourUnaligned __attribute__((vector_size(32), aligned(8), may_alias));

void multiply_lanes(int width, const double* d, const double* in, double* out) {
    for (int row = 0; row < width; ++row, d += width) {
        Four even{};
        Four odd{};
        int column = 0;
        for (; column + 2 <= width; column += 2) {
            even += d[column] * *reinterpret_cast<const FourUnaligned*>(in + 4 * column);
            odd += d[column + 1] * *reinterpret_cast<const FourUnaligned*>(in + 4 * column + 4);
        }
        even += d[column] * *reinterpret_cast<const FourUnaligned*>(in + 4 * column);
        *reinterpret_cast<FourUnaligned*>(out + 4 * row) = even + odd;
    }
}

/// Every second degree, `N` of them, each its cosine and its sine: 2 N chains of additions.
template <int N>
void add_degrees(const FourUnaligned* cosine, const FourUnaligned* sine, long count, const double* table,
                 double* sums) {
    Four sum[2 * N] = {};
    for (long i = 0; i < count; ++i) {
        const Four c = cosine[i], s = sine[i];
        for (int k = 0; k < N; ++k) {
            const double* pair = table + 4 * k * count + 2 * i;
            sum[2 * k] += pair[0] * c;
            sum[2 * k + 1] += pair[1] * s;
        }
    }
    FourUnaligned* out = reinterpret_cast<FourUnaligned*>(sums);
    for (int k = 0; k < N; ++k) {
        out[4 * k] += sum[2 * k];
        out[4 * k + 1] += sum[2 * k + 1];
    }
}

void low_degrees(const double* folded, int count, const double* table, int degrees, double* sums) {
    const FourUnaligned* four = reinterpret_cast<const FourUnaligned*>(folded);
    const long n = count;
    for (int parity = 0; parity < 2; ++parity) {
        const FourUnaligned* cosine = four + parity * n;
        const FourUnaligned* sine = four + (2 + parity) * n;
        for (int m = parity; m < degrees;) {
            const int left = (degrees - m + 1) / 2;
            const double* a = table + 2 * m * n;
            double* out = sums + 8 * m;
            if (left == 4 || left > 5) {
                add_degrees<4>(cosine, sine, n, a, out);
                m += 8;
            } else if (left >= 3) {
                add_degrees<3>(cosine, sine, n, a, out);
                m += 6;
            } else if (left == 2) {
                add_degrees<2>(cosine, sine, n, a, out);
                m += 4;
            } else {
                add_degrees<1>(cosine, sine, n, a, out);
                m += 2;
            }
        }
    }
}

}  // namespace
}  // namespace nicol
