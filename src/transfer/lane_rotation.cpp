// SPDX-License-Identifier: MIT
#include "transfer/lane_rotation.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "nicol/psh.hpp"
#include "nicol/wigner.hpp"
#include "transfer/lane_vector.hpp"
#include "transfer/simd.hpp"

namespace nicol {
namespace {

// cos and sin of m phi, or m theta, for m = 0, 1, ...
struct Angles {
    const Lanes* cosine;
    const Lanes* sine;
};

// Rows a, a + 2, ... of a quarter times every other number of x.
template <int Rows>
[[gnu::always_inline]] inline void multiply_rows(const float* matrix, int l, int a, int n0, const Lanes* x,
                                                 Lanes* out) {
    const int stride = l + 1;
    const float* m = matrix + a * stride;
    LaneVector sum[Rows] = {};
    for (int n = n0; n <= l; n += 2) {
        LaneVector value;
        load(x + n, value);
        for (int r = 0; r < Rows; ++r) sum[r] += m[2 * r * stride + n] * value;
    }
    for (int r = 0; r < Rows; ++r) store(out + a + 2 * r, sum[r]);
}

// out[a] = sum of matrix[a][n] x[n] over a = a0, a0 + 2, ... and n = n0, n0 + 2, ..., both at most l.
[[gnu::always_inline]] inline void multiply(const float* matrix, int l, int a0, int n0, const Lanes* x,
                                            Lanes* out) {
    int a = a0;
    for (; a + 6 <= l; a += 8) multiply_rows<4>(matrix, l, a, n0, x, out);
    if (a + 2 <= l) {
        multiply_rows<2>(matrix, l, a, n0, x, out);
        a += 4;
    }
    if (a <= l) multiply_rows<1>(matrix, l, a, n0, x, out);
}

// A real field has h_-m = (-1)^m conj(h_m), also between the two products, so each column contributes either
// its real or its imaginary part: the columns with n = l + a mod 2 make the real part of row a, the others
// the imaginary one.
[[gnu::always_inline]] inline void multiply_real(const float* matrix, int l, const Lanes* re, const Lanes* im,
                                                 Lanes* re_out, Lanes* im_out) {
    for (int a = 0; a < 2; ++a) {
        multiply(matrix, l, a, (l + a) % 2, re, re_out);
        multiply(matrix, l, a, (l + a + 1) % 2, im, im_out);
    }
}

// z (c + i s), or with its conjugate.
[[gnu::always_inline]] inline void spread(std::complex<float> z, const Angles& by, int m, float sign,
                                          Lanes* re, Lanes* im) {
    LaneVector c;
    LaneVector s;
    load(by.cosine + m, c);
    load(by.sine + m, s);
    s *= sign;
    store(re, z.real() * c - z.imag() * s);
    store(im, z.imag() * c + z.real() * s);
}

[[gnu::always_inline]] inline void turn(Lanes* re, Lanes* im, const Angles& by, int m, float sign) {
    LaneVector c;
    LaneVector s;
    LaneVector x;
    LaneVector y;
    load(by.cosine + m, c);
    load(by.sine + m, s);
    load(re, x);
    load(im, y);
    s *= sign;
    store(re, x * c - y * s);
    store(im, y * c + x * s);
}

NICOL_MULTIVERSION
void turn_real_field(int order, const float* first, const float* second, const std::complex<float>* in,
                     Angles azimuth, Angles zenith, Lanes* re, Lanes* im, Lanes* scratch) {
    Lanes* const other_re = scratch;
    Lanes* const other_im = scratch + order + 1;
    for (int l = 0; l <= order; ++l) {
        for (int m = 0; m <= l; ++m) spread(in[m], azimuth, m, 1, re + m, im + m);
        multiply_real(first, l, re, im, other_re, other_im);
        for (int k = 0; k <= l; ++k) turn(other_re + k, other_im + k, zenith, k, 1);
        multiply_real(second, l, other_re, other_im, re, im);
        const int size = l + 1;
        first += size * size;
        second += size * size;
        in += size;
        re += size;
        im += size;
    }
}

// out_{+-a} = E +- O: sums over columns with n = l mod 2 and over the others, of h_n + h_-n where l + a is
// even and of h_n - h_-n where it is odd.
[[gnu::always_inline]] inline void multiply_complex(const float* matrix, int l, Lanes* centre,
                                                    Lanes* scratch) {
    Lanes* const sum = scratch;
    Lanes* const difference = scratch + l + 1;
    Lanes* const same = scratch + 2 * (l + 1);
    Lanes* const other = scratch + 3 * (l + 1);
    sum[0] = *centre;
    difference[0] = Lanes{};
    for (int n = 1; n <= l; ++n) {
        LaneVector x;
        LaneVector y;
        load(centre + n, x);
        load(centre - n, y);
        store(sum + n, x + y);
        store(difference + n, x - y);
    }
    for (int a = 0; a < 2; ++a) {
        const Lanes* x = (l + a) % 2 == 0 ? sum : difference;
        multiply(matrix, l, a, l % 2, x, same);
        multiply(matrix, l, a, (l + 1) % 2, x, other);
    }
    for (int a = 0; a <= l; ++a) {
        LaneVector x;
        LaneVector y;
        load(same + a, x);
        load(other + a, y);
        store(centre + a, x + y);
        if (a > 0) store(centre - a, x - y);
    }
}

NICOL_MULTIVERSION
void turn_complex_field(int order, const float* first, const float* second, const std::complex<float>* in,
                        Angles azimuth, Angles zenith, Lanes* re, Lanes* im, Lanes* scratch) {
    for (int l = 0; l <= order; ++l) {
        const int middle = l * l + l;
        for (int m = -l; m <= l; ++m) {
            const int at = middle + m;
            spread(in[at], azimuth, m < 0 ? -m : m, m < 0 ? -1.0F : 1.0F, re + at, im + at);
        }
        multiply_complex(first, l, re + middle, scratch);
        multiply_complex(first, l, im + middle, scratch);
        for (int k = -l; k <= l; ++k) {
            turn(re + middle + k, im + middle + k, zenith, k < 0 ? -k : k, k < 0 ? -1.0F : 1.0F);
        }
        multiply_complex(second, l, re + middle, scratch);
        multiply_complex(second, l, im + middle, scratch);
        first += (l + 1) * (l + 1);
        second += (l + 1) * (l + 1);
    }
}

using Coordinates = std::array<double, kLanes>;

// Of the turns by phi + pi / 2 and by -theta.
struct Turns {
    alignas(64) Coordinates azimuth_cosine;
    alignas(64) Coordinates azimuth_sine;
    alignas(64) Coordinates zenith_cosine;
    alignas(64) Coordinates zenith_sine;
};

NICOL_MULTIVERSION
void find_turns(const Coordinates& x, const Coordinates& y, const Coordinates& z, Turns& out) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const double rho = std::sqrt(x[i] * x[i] + y[i] * y[i]);
        // At a pole theta_phi_frame takes phi as 0, and so must this. The quarter turn is i exp(i phi).
        const double inverse = 1 / (rho > 0 ? rho : 1);
        out.azimuth_cosine[i] = -y[i] * inverse;
        out.azimuth_sine[i] = rho > 0 ? x[i] * inverse : 1;
        const double length = std::sqrt(rho * rho + z[i] * z[i]);
        out.zenith_cosine[i] = z[i] / length;
        out.zenith_sine[i] = -rho / length;
    }
}

// exp(i m angle) for m = 0..count-1 from exp(i angle), in double so that high powers keep their digits.
NICOL_MULTIVERSION
void raise(const Coordinates& cosine, const Coordinates& sine, std::size_t count, Lanes* cosines,
           Lanes* sines) {
    alignas(64) Coordinates re{};
    alignas(64) Coordinates im{};
    re.fill(1);
    for (std::size_t m = 0; m < count; ++m) {
        for (std::size_t i = 0; i < kLanes; ++i) cosines[m].value[i] = static_cast<float>(re[i]);
        for (std::size_t i = 0; i < kLanes; ++i) sines[m].value[i] = static_cast<float>(im[i]);
        for (std::size_t i = 0; i < kLanes; ++i) {
            const double next = re[i] * cosine[i] - im[i] * sine[i];
            im[i] = im[i] * cosine[i] + re[i] * sine[i];
            re[i] = next;
        }
    }
}

}  // namespace

LaneRotation::LaneRotation(int order) : order_(order) {
    const std::vector<double> d = wigner_d(order, -std::numbers::pi / 2);
    for (int l = 0; l <= order; ++l) {
        const auto element = [&](int m, int n) {
            return static_cast<float>(
                d[wigner_offset(l) + static_cast<std::size_t>((m + l) * (2 * l + 1) + n + l)]);
        };
        for (int row = 0; row <= l; ++row) {
            for (int column = 0; column <= l; ++column) {
                const float pair = column == 0 ? 1.0F : 2.0F;
                complex_.first.push_back(element(column, row));
                complex_.second.push_back(element(row, column));
                real_.first.push_back(pair * element(column, row));
                real_.second.push_back(pair * element(row, column));
            }
        }
    }
}

LaneRotation::Work LaneRotation::work() const {
    const auto count = static_cast<std::size_t>(order_) + 1;
    Work work;
    for (Work::Phases* phases : {&work.azimuth_, &work.zenith_}) {
        phases->cosine.resize(count);
        phases->sine.resize(count);
    }
    work.re_.resize(psh_count(order_));
    work.im_.resize(psh_count(order_));
    work.scratch_.resize(4 * count);
    return work;
}

void LaneRotation::set_normals(std::span<const glm::vec3> normals, Work& work) const {
    alignas(64) Coordinates x;
    alignas(64) Coordinates y;
    alignas(64) Coordinates z;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::dvec3 n(normals[i < normals.size() ? i : 0]);
        x[i] = n.x;
        y[i] = n.y;
        z[i] = n.z;
    }
    Turns turns;
    find_turns(x, y, z, turns);
    const auto count = static_cast<std::size_t>(order_) + 1;
    raise(turns.azimuth_cosine, turns.azimuth_sine, count, work.azimuth_.cosine.data(),
          work.azimuth_.sine.data());
    raise(turns.zenith_cosine, turns.zenith_sine, count, work.zenith_.cosine.data(),
          work.zenith_.sine.data());
}

void LaneRotation::turn_real(std::span<const std::complex<float>> in, Work& work) const {
    turn_real_field(order_, real_.first.data(), real_.second.data(), in.data(),
                    {work.azimuth_.cosine.data(), work.azimuth_.sine.data()},
                    {work.zenith_.cosine.data(), work.zenith_.sine.data()}, work.re_.data(), work.im_.data(),
                    work.scratch_.data());
}

void LaneRotation::turn_complex(std::span<const std::complex<float>> in, Work& work) const {
    turn_complex_field(order_, complex_.first.data(), complex_.second.data(), in.data(),
                       {work.azimuth_.cosine.data(), work.azimuth_.sine.data()},
                       {work.zenith_.cosine.data(), work.zenith_.sine.data()}, work.re_.data(),
                       work.im_.data(), work.scratch_.data());
}

}  // namespace nicol
