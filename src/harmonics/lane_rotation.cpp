// SPDX-License-Identifier: MIT
#include "harmonics/lane_rotation.hpp"

#include <cmath>
#include <numbers>

#include "harmonics/psh.hpp"
#include "harmonics/wigner.hpp"
#include "simd/dispatch.hpp"
#include "simd/lane_phases.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

// Cosine and sine of m phi, or of m theta, for m = 0, 1, ...
struct Angles {
    const Lanes* cosine;
    const Lanes* sine;
};

// multiply() is inlined at each call, for each kind of processor. One call inside a loop, instead of several,
// keeps compile times short.

// Multiplies rows a, a + 2, ... of a quarter by every other number of Fields fields x.
template <int Fields, int Rows>
[[gnu::always_inline]] inline void multiply_rows(const float* matrix, int l, int a, int n0, const Lanes* x,
                                                 Lanes* out) {
    const int stride = l + 1;
    const float* m = matrix + a * stride;
    LaneVector sum[Rows][Fields] = {};
    for (int n = n0; n <= l; n += 2) {
        for (int f = 0; f < Fields; ++f) {
            LaneVector value;
            load(x + Fields * n + f, value);
            for (int r = 0; r < Rows; ++r) sum[r][f] += m[2 * r * stride + n] * value;
        }
    }
    for (int r = 0; r < Rows; ++r) {
        for (int f = 0; f < Fields; ++f) store(out + Fields * (a + 2 * r) + f, sum[r][f]);
    }
}

// Computes out[a] = sum of matrix[a][n] x[n] over a = a0, a0 + 2, ... and n = n0, n0 + 2, ..., both at most
// l.
template <int Fields>
[[gnu::always_inline]] inline void multiply(const float* matrix, int l, int a0, int n0, const Lanes* x,
                                            Lanes* out) {
    int a = a0;
    for (; a + 6 <= l; a += 8) multiply_rows<Fields, 4>(matrix, l, a, n0, x, out);
    if (a + 2 <= l) {
        multiply_rows<Fields, 2>(matrix, l, a, n0, x, out);
        a += 4;
    }
    if (a <= l) multiply_rows<Fields, 1>(matrix, l, a, n0, x, out);
}

// Multiplies a real field. Because h_-m = (-1)^m conj(h_m), also between the two products, each column
// contributes either its real or its imaginary part: columns with n = l + a mod 2 contribute to the real part
// of row a, the others to its imaginary part.
template <int Fields>
[[gnu::always_inline]] inline void multiply_real(const float* matrix, int l, const Lanes* re, const Lanes* im,
                                                 Lanes* re_out, Lanes* im_out) {
    for (int half = 0; half < 4; ++half) {
        const int a = half / 2;
        const bool real = half % 2 == 0;
        multiply<Fields>(matrix, l, a, (l + half - a) % 2, real ? re : im, real ? re_out : im_out);
    }
}

// Loads c + i s, or c - i s for sign -1.
[[gnu::always_inline]] inline void load_phase(const Angles& by, int m, float sign, LaneVector& c,
                                              LaneVector& s) {
    load(by.cosine + m, c);
    load(by.sine + m, s);
    s *= sign;
}

// Stores (x + i y) (c + i s).
template <class Number>
[[gnu::always_inline]] inline void store_turned(const Number& x, const Number& y, const LaneVector& c,
                                                const LaneVector& s, Lanes* re, Lanes* im) {
    store(re, x * c - y * s);
    store(im, y * c + x * s);
}

// Computes z (c + i s), or z (c - i s) for sign -1; z is one number for all lanes.
template <int Fields>
[[gnu::always_inline]] inline void spread(const std::complex<float>* const* in, int at, const Angles& by,
                                          int m, float sign, Lanes* re, Lanes* im) {
    LaneVector c;
    LaneVector s;
    load_phase(by, m, sign, c, s);
    for (int f = 0; f < Fields; ++f) {
        store_turned(in[f][at].real(), in[f][at].imag(), c, s, re + f, im + f);
    }
}

// Multiplies the number in each lane by c + i s, or by c - i s for sign -1.
template <int Fields>
[[gnu::always_inline]] inline void multiply_phase(Lanes* re, Lanes* im, const Angles& by, int m, float sign) {
    LaneVector c;
    LaneVector s;
    load_phase(by, m, sign, c, s);
    for (int f = 0; f < Fields; ++f) {
        LaneVector x;
        LaneVector y;
        load(re + f, x);
        load(im + f, y);
        store_turned(x, y, c, s, re + f, im + f);
    }
}

// Arguments of a rotation. The fields are `in` (one for all lanes) or, if that is null, `re` and `im` (one in
// each lane).
struct Rotation {
    int order;
    bool back;
    const float* first;
    const float* second;
    const std::complex<float>* const* in;
    Angles azimuth;
    Angles zenith;
    Lanes* re;
    Lanes* im;
    Lanes* scratch;
};

// Multiplies by the azimuth's phase, which is the first step of a rotation and the last step of the reverse.
template <int Fields>
[[gnu::always_inline]] inline void multiply_azimuth(const Rotation& t, int at, int m, Lanes* re, Lanes* im) {
    const float sign = (m < 0) != t.back ? -1.0F : 1.0F;
    if (t.in != nullptr) {
        spread<Fields>(t.in, at, t.azimuth, m < 0 ? -m : m, sign, re, im);
    } else {
        multiply_phase<Fields>(re, im, t.azimuth, m < 0 ? -m : m, sign);
    }
}

template <int Fields>
[[gnu::always_inline]] inline void rotate_real_fields(const Rotation& t) {
    const float zenith_sign = t.back ? -1.0F : 1.0F;
    const float* first = t.first;
    const float* second = t.second;
    Lanes* const other_re = t.scratch;
    Lanes* const other_im = t.scratch + Fields * (t.order + 1);
    int begin = 0;
    for (int l = 0; l <= t.order; ++l) {
        Lanes* const re = t.re + Fields * begin;
        Lanes* const im = t.im + Fields * begin;
        for (int m = 0; m <= l && !t.back; ++m) {
            multiply_azimuth<Fields>(t, begin + m, m, re + Fields * m, im + Fields * m);
        }
        for (const bool back : {false, true}) {
            multiply_real<Fields>(back ? second : first, l, back ? other_re : re, back ? other_im : im,
                                  back ? re : other_re, back ? im : other_im);
            for (int k = 1; k <= l && !back; ++k) {
                multiply_phase<Fields>(other_re + Fields * k, other_im + Fields * k, t.zenith, k,
                                       zenith_sign);
            }
        }
        for (int m = 0; m <= l && t.back; ++m) {
            multiply_azimuth<Fields>(t, begin + m, m, re + Fields * m, im + Fields * m);
        }
        first += (l + 1) * (l + 1);
        second += (l + 1) * (l + 1);
        begin += l + 1;
    }
}

// Computes out_{+-a} = E +- O. E is a sum over columns with n = l mod 2, O over the other columns. The terms
// are h_n + h_-n if l + a is even, and h_n - h_-n if it is odd.
template <int Fields>
[[gnu::always_inline]] inline void multiply_complex(const float* matrix, int l, Lanes* centre,
                                                    Lanes* scratch) {
    Lanes* const sum = scratch;
    Lanes* const difference = scratch + Fields * (l + 1);
    Lanes* const same = scratch + 2 * Fields * (l + 1);
    Lanes* const other = scratch + 3 * Fields * (l + 1);
    for (int n = 0; n <= l; ++n) {
        for (int f = 0; f < Fields; ++f) {
            LaneVector x;
            LaneVector y;
            load(centre + Fields * n + f, x);
            load(centre - Fields * n + f, y);
            store(sum + Fields * n + f, n == 0 ? x : x + y);
            store(difference + Fields * n + f, x - y);
        }
    }
    for (int half = 0; half < 4; ++half) {
        const int a = half / 2;
        const Lanes* x = (l + a) % 2 == 0 ? sum : difference;
        multiply<Fields>(matrix, l, a, (l + half) % 2, x, half % 2 == 0 ? same : other);
    }
    for (int a = 0; a <= l; ++a) {
        for (int f = 0; f < Fields; ++f) {
            LaneVector x;
            LaneVector y;
            load(same + Fields * a + f, x);
            load(other + Fields * a + f, y);
            store(centre - Fields * a + f, x - y);
            store(centre + Fields * a + f, x + y);
        }
    }
}

template <int Fields>
[[gnu::always_inline]] inline void rotate_complex_fields(const Rotation& t) {
    const float* first = t.first;
    const float* second = t.second;
    for (int l = 0; l <= t.order; ++l) {
        const int middle = l * l + l;
        Lanes* const re = t.re + Fields * middle;
        Lanes* const im = t.im + Fields * middle;
        for (int m = -l; m <= l && !t.back; ++m) {
            multiply_azimuth<Fields>(t, middle + m, m, re + Fields * m, im + Fields * m);
        }
        for (int half = 0; half < 4; ++half) {
            multiply_complex<Fields>(half < 2 ? first : second, l, half % 2 == 0 ? re : im, t.scratch);
            for (int k = -l; k <= l && half == 1; ++k) {
                multiply_phase<Fields>(re + Fields * k, im + Fields * k, t.zenith, k < 0 ? -k : k,
                                       (k < 0) != t.back ? -1.0F : 1.0F);
            }
        }
        for (int m = -l; m <= l && t.back; ++m) {
            multiply_azimuth<Fields>(t, middle + m, m, re + Fields * m, im + Fields * m);
        }
        first += (l + 1) * (l + 1);
        second += (l + 1) * (l + 1);
    }
}

[[gnu::always_inline]] inline void rotate_some_real(const Rotation& t, std::size_t fields) {
    static_assert(LaneRotation::kMostFields == 3);
    if (fields == 1) rotate_real_fields<1>(t);
    if (fields == 2) rotate_real_fields<2>(t);
    if (fields == 3) rotate_real_fields<3>(t);
}

[[gnu::always_inline]] inline void rotate_some_complex(const Rotation& t, std::size_t fields) {
    if (fields == 1) rotate_complex_fields<1>(t);
    if (fields == 2) rotate_complex_fields<2>(t);
    if (fields == 3) rotate_complex_fields<3>(t);
}

// Cosines and sines of the rotation angles phi + pi / 2 and -theta.
struct Rotations {
    DoubleLanes azimuth_cosine;
    DoubleLanes azimuth_sine;
    DoubleLanes zenith_cosine;
    DoubleLanes zenith_sine;
};

[[gnu::always_inline]] inline void find_rotations(const DoubleLanes& x, const DoubleLanes& y,
                                                  const DoubleLanes& z, Rotations& out) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const double rho = std::sqrt(x.value[i] * x.value[i] + y.value[i] * y.value[i]);
        // theta_phi_frame takes phi as 0 at a pole, and this function must agree. The added pi / 2 is the
        // factor i in i exp(i phi).
        const double inverse = 1 / (rho > 0 ? rho : 1);
        out.azimuth_cosine.value[i] = -y.value[i] * inverse;
        out.azimuth_sine.value[i] = rho > 0 ? x.value[i] * inverse : 1;
        const double length = std::sqrt(rho * rho + z.value[i] * z.value[i]);
        out.zenith_cosine.value[i] = z.value[i] / length;
        out.zenith_sine.value[i] = -rho / length;
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

LaneRotation::Work::Work(int order) {
    const auto count = static_cast<std::size_t>(order) + 1;
    for (Phases* phases : {&azimuth_, &zenith_}) {
        phases->cosine.resize(count);
        phases->sine.resize(count);
    }
    fields_.resize(2 * kMostFields * psh_count(order));
    scratch_.resize(4 * kMostFields * count);
}

LaneRotation::Work& LaneRotation::work_of_thread() const {
    thread_local Work work(order_);
    // Made anew as a whole: where memory runs out, the former work space stays.
    if (work.azimuth_.cosine.size() != static_cast<std::size_t>(order_) + 1) work = Work(order_);
    return work;
}

void LaneRotation::set_normals(std::span<const glm::vec3> normals, Work& work) const {
    DoubleLanes x;
    DoubleLanes y;
    DoubleLanes z;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::dvec3 n(normals[i < normals.size() ? i : 0]);
        x.value[i] = n.x;
        y.value[i] = n.y;
        z.value[i] = n.z;
    }
    Rotations rotations;
    dispatch<find_rotations>(x, y, z, rotations);
    const auto count = static_cast<std::size_t>(order_) + 1;
    raise_phases(rotations.azimuth_cosine, rotations.azimuth_sine, count, work.azimuth_.cosine.data(),
                 work.azimuth_.sine.data());
    raise_phases(rotations.zenith_cosine, rotations.zenith_sine, count, work.zenith_.cosine.data(),
                 work.zenith_.sine.data());
}

void LaneRotation::rotate_by(Field kind, const std::complex<float>* const* in, std::size_t fields, bool back,
                             Work& work) const {
    const Quarters& quarters = kind == Field::real ? real_ : complex_;
    const Rotation rotation{.order = order_,
                            .back = back,
                            .first = quarters.first.data(),
                            .second = quarters.second.data(),
                            .in = in,
                            .azimuth = {work.azimuth_.cosine.data(), work.azimuth_.sine.data()},
                            .zenith = {work.zenith_.cosine.data(), work.zenith_.sine.data()},
                            .re = work.fields_.data(),
                            .im = work.fields_.data() + fields * work.imaginary(),
                            .scratch = work.scratch_.data()};
    if (kind == Field::real) {
        dispatch<rotate_some_real>(rotation, fields);
    } else {
        dispatch<rotate_some_complex>(rotation, fields);
    }
}

void LaneRotation::rotate(Field kind, std::span<const std::complex<float>* const> in, Work& work) const {
    rotate_by(kind, in.data(), in.size(), false, work);
}

void LaneRotation::rotate(Field kind, std::size_t fields, Work& work) const {
    rotate_by(kind, nullptr, fields, false, work);
}

void LaneRotation::rotate_back(Field kind, std::size_t fields, Work& work) const {
    rotate_by(kind, nullptr, fields, true, work);
}

}  // namespace nicol
