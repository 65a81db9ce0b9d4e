// SPDX-License-Identifier: MIT
#include "harmonics/rotation.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "harmonics/wigner.hpp"
#include "simd/dispatch.hpp"
#include "simd/double_vectors.hpp"

namespace nicol {
namespace {

using Complex = std::complex<double>;

/// Returns the unit quaternion (w, x, y, z) of a rotation, from the largest of its four components
/// (Shepperd).
std::array<double, 4> quaternion(const glm::dmat3& r) {
    const double xx = r[0][0];
    const double yy = r[1][1];
    const double zz = r[2][2];
    const std::array<double, 4> squares = {1 + xx + yy + zz, 1 + xx - yy - zz, 1 - xx + yy - zz,
                                           1 - xx - yy + zz};
    const double wx = r[1][2] - r[2][1];
    const double wy = r[2][0] - r[0][2];
    const double wz = r[0][1] - r[1][0];
    const double xy = r[1][0] + r[0][1];
    const double xz = r[2][0] + r[0][2];
    const double yz = r[2][1] + r[1][2];
    std::array<double, 4> q{};
    switch (std::ranges::max_element(squares) - squares.begin()) {
        case 0:
            q = {squares[0], wx, wy, wz};
            break;
        case 1:
            q = {wx, squares[1], xy, xz};
            break;
        case 2:
            q = {wy, xy, squares[2], yz};
            break;
        default:
            q = {wz, xz, yz, squares[3]};
            break;
    }
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (double& component : q) component /= length;
    return q;
}

Complex unit(double re, double im) {
    const double length = std::hypot(re, im);
    return length > 0 ? Complex(re / length, im / length) : Complex(1, 0);
}

/// Returns conj(z)^m for m = 0..order. Each power is a product of two powers of half its degree, so that
/// errors grow with log m.
std::vector<Complex> conjugate_powers(Complex z, int order) {
    std::vector<Complex> powers(static_cast<std::size_t>(order) + 1);
    powers[0] = 1;
    if (order > 0) powers[1] = std::conj(z);
    for (std::size_t m = 2; m < powers.size(); ++m) powers[m] = powers[m / 2] * powers[m - m / 2];
    return powers;
}

// Four numbers per degree: the complex-harmonics coefficients of s0 + i s3 and of s1 + i s2. Because s0 and
// s3 are real fields, the complex sum loses nothing, and both coefficients rotate by one D (Eqs. 9 and 36).
struct PairOfFields {
    double v[4];
};

void load_fields(int l, const double* in, const std::vector<Complex>& phase, PairOfFields* out) {
    const double half = std::numbers::sqrt2 / 2;
    const auto put = [&](int m, Complex scalar, Complex spin) {
        const Complex e =
            m >= 0 ? phase[static_cast<std::size_t>(m)] : std::conj(phase[static_cast<std::size_t>(-m)]);
        const double a = e.real();
        const double b = e.imag();
        out[m] = {{scalar.real() * a - scalar.imag() * b, scalar.real() * b + scalar.imag() * a,
                   spin.real() * a - spin.imag() * b, spin.real() * b + spin.imag() * a}};
    };
    put(0, {in[0], in[3]}, {in[1], in[2]});
    for (int m = 1; m <= l; ++m) {
        const double* p = in + 4 * m;
        const double* n = in - 4 * m;
        const double sign = parity(m) * half;
        put(m, {half * (p[0] + n[3]), half * (p[3] - n[0])}, {p[1], p[2]});
        put(-m, {sign * (p[0] - n[3]), sign * (p[3] + n[0])}, {n[1], n[2]});
    }
}

void store_fields(int l, const PairOfFields* in, const std::vector<Complex>& phase, double* out) {
    const double half = std::numbers::sqrt2 / 2;
    const auto rotated = [&](int m, int lane) {
        const Complex e =
            m >= 0 ? phase[static_cast<std::size_t>(m)] : std::conj(phase[static_cast<std::size_t>(-m)]);
        const double a = in[m].v[lane];
        const double b = in[m].v[lane + 1];
        return Complex(a * e.real() - b * e.imag(), a * e.imag() + b * e.real());
    };
    out[0] = in[0].v[0];
    out[1] = in[0].v[2];
    out[2] = in[0].v[3];
    out[3] = in[0].v[1];
    for (int m = 1; m <= l; ++m) {
        const Complex plus = rotated(m, 0);
        const Complex minus = parity(m) * rotated(-m, 0);
        const Complex spin_plus = rotated(m, 2);
        const Complex spin_minus = rotated(-m, 2);
        double* p = out + 4 * m;
        double* n = out - 4 * m;
        p[0] = half * (plus.real() + minus.real());
        p[3] = half * (plus.imag() + minus.imag());
        n[0] = -half * (plus.imag() - minus.imag());
        n[3] = half * (plus.real() - minus.real());
        p[1] = spin_plus.real();
        p[2] = spin_plus.imag();
        n[1] = spin_minus.real();
        n[2] = spin_minus.imag();
    }
}

// Computes out[row] = sum over columns of d[row * width + column] in[column], with in and out in groups of
// four.
[[gnu::always_inline]] inline void multiply_fours(int width, const double* d, const double* in, double* out) {
    using Four = DoubleVectors<4>::Vector;
    for (int row = 0; row < width; ++row, d += width) {
        Four first;
        Four second;
        Four even{};
        Four odd{};
        int column = 0;
        for (; column + 2 <= width; column += 2) {
            load_vector(in + 4 * column, first);
            load_vector(in + 4 * column + 4, second);
            even += d[column] * first;
            odd += d[column + 1] * second;
        }
        load_vector(in + 4 * column, first);
        even += d[column] * first;
        store_vector(out + 4 * row, even + odd);
    }
}

}  // namespace

EulerZyz euler_zyz(const glm::dmat3& r) {
    double deviation = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double dot = r[i][0] * r[j][0] + r[i][1] * r[j][1] + r[i][2] * r[j][2];
            deviation = std::max(deviation, std::isfinite(dot) ? std::abs(dot - (i == j ? 1 : 0)) : 1e300);
        }
    const double determinant = r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1]) -
                               r[0][1] * (r[1][0] * r[2][2] - r[1][2] * r[2][0]) +
                               r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
    require(deviation <= 1e-5, "rotation is not orthonormal (deviation " + std::to_string(deviation) +
                                   "), expected at most 1e-5");
    require(determinant > 0, "rotation is a reflection (determinant -1), expected a right-handed matrix");
    const auto [w, x, y, z] = quaternion(r);
    // The quaternion directly contains half the sum and half the difference of alpha and gamma.
    const Complex sum = unit(w, z);
    const Complex difference = unit(y, x);
    return {sum * std::conj(difference), sum * difference, std::hypot(x, y), std::hypot(w, z)};
}

PshRotation::PshRotation(int order, const glm::dmat3& rotation) : order_(order) {
    require_order(order);
    euler_ = euler_zyz(rotation);
    alpha_ = conjugate_powers(euler_.alpha, order);
    gamma_ = conjugate_powers(euler_.gamma, order);
    if (order > kStoredOrder) return;
    d_.resize(wigner_offset(order + 1));
    WignerSweep sweep(order, {euler_.sin_half_beta, euler_.cos_half_beta});
    for (int l = 0;; ++l) {
        sweep.block(d_.data() + wigner_offset(l));
        if (l == order) return;
        sweep.step();
    }
}

void PshRotation::apply(std::span<const double> in, std::span<double> out) const {
    const std::size_t size = 4 * psh_count(order_);
    require_size(out.size(), in.size(), "out");
    require(in.size() % size == 0, "in holds " + std::to_string(in.size()) +
                                       " values, expected a multiple of " + std::to_string(size));
    const auto widest = static_cast<std::size_t>(2 * order_ + 1);
    std::vector<PairOfFields> from(widest);
    std::vector<PairOfFields> to(widest);
    std::vector<double> transient;
    std::vector<WignerSweep> sweep;
    if (d_.empty()) {
        transient.resize(widest * widest);
        sweep.emplace_back(order_, HalfAngle{euler_.sin_half_beta, euler_.cos_half_beta});
    }
    for (int l = 0; l <= order_; ++l) {
        if (!sweep.empty()) {
            if (l > 0) sweep[0].step();
            sweep[0].block(transient.data());
        }
        const double* d = sweep.empty() ? d_.data() + wigner_offset(l) : transient.data();
        const std::size_t centre = 4 * psh_index(l, 0);
        for (std::size_t base = 0; base < in.size(); base += size) {
            load_fields(l, in.data() + base + centre, gamma_, from.data() + l);
            dispatch<multiply_fours>(2 * l + 1, d, from[0].v, to[0].v);
            store_fields(l, to.data() + l, alpha_, out.data() + base + centre);
        }
    }
}

PshVector rotated(const PshVector& field, const glm::dmat3& rotation) {
    require(field.channels() > 0, "field is empty");
    require_finite(field.data(), "field");
    PshVector out(field.order(), field.channels());
    PshRotation(field.order(), rotation).apply(field.data(), out.data());
    return out;
}

}  // namespace nicol
