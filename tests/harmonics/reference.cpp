// SPDX-License-Identifier: MIT
#include "harmonics/reference.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

namespace reference {
namespace {

namespace mp = boost::multiprecision;

template <class Real>
std::vector<Real> factorials(int count) {
    std::vector<Real> out(static_cast<std::size_t>(count) + 1);
    out[0] = 1;
    for (int i = 1; i <= count; ++i)
        out[static_cast<std::size_t>(i)] = out[static_cast<std::size_t>(i) - 1] * i;
    return out;
}

/// Evaluates Wigner's sum, which loses up to 2 l bits to cancellation.
template <unsigned Bits>
double wigner_sum(int l, int m, int n, double theta) {
    using Real = mp::number<mp::cpp_bin_float<Bits, mp::digit_base_2>, mp::et_off>;
    const Real half = Real(theta) / 2;
    const Real s = sin(half);
    const Real c = cos(half);
    const int first = std::max(0, n - m);
    const int last = std::min(l + n, l - m);
    static const std::vector<Real> factorial = factorials<Real>(Bits > 2560 ? 8200 : 2100);
    const auto f = [&](int i) { return factorial[static_cast<std::size_t>(i)]; };
    const Real below = f(l + n - first) * f(first) * f(m - n + first) * f(l - m - first);
    const int cos_power = 2 * l + n - m - 2 * first;
    const int sin_power = m - n + 2 * first;
    if (s == 0 && sin_power > 0) return 0;
    Real term = sqrt(f(l + m) * f(l - m) * f(l + n) * f(l - n)) / below *
                (cos_power > 0 ? Real(pow(c, cos_power)) : Real(1)) *
                (sin_power > 0 ? Real(pow(s, sin_power)) : Real(1));
    if ((m - n + first) % 2 != 0) term = -term;
    const Real ratio = -(s / c) * (s / c);
    Real sum = term;
    for (int k = first; k < last; ++k) {
        term *= ratio * ((l + n - k) * (l - m - k));
        term /= (k + 1) * (m - n + k + 1);
        sum += term;
    }
    return static_cast<double>(sum);
}

}  // namespace

double wigner_d(int l, int m, int n, double theta) {
    if (l <= 40) return wigner_sum<256>(l, m, n, theta);
    if (l <= 200) return wigner_sum<768>(l, m, n, theta);
    if (l <= 1100) return wigner_sum<2560>(l, m, n, theta);
    return wigner_sum<8704>(l, m, n, theta);
}

double spin_harmonic(int spin, int l, int m, double theta) {
    if (l < std::abs(spin) || l < std::abs(m)) return 0;
    return (spin % 2 == 0 ? 1 : -1) * std::sqrt((2 * l + 1) / (4 * std::numbers::pi)) *
           wigner_d(l, m, -spin, theta);
}

double wigner_3j(int l1, int l2, int l3, int m1, int m2, int m3) {
    using Real = mp::number<mp::cpp_bin_float<1200, mp::digit_base_2>, mp::et_off>;
    if (m1 + m2 + m3 != 0 || l1 > l2 + l3 || l1 < std::abs(l2 - l3)) return 0;
    if (std::abs(m1) > l1 || std::abs(m2) > l2 || std::abs(m3) > l3) return 0;
    static const std::vector<Real> factorial = factorials<Real>(2100);
    const auto f = [&](int i) { return factorial[static_cast<std::size_t>(i)]; };
    const Real triangle = f(l1 + l2 - l3) * f(l1 - l2 + l3) * f(-l1 + l2 + l3) / f(l1 + l2 + l3 + 1);
    const Real outer = f(l1 + m1) * f(l1 - m1) * f(l2 + m2) * f(l2 - m2) * f(l3 + m3) * f(l3 - m3);
    Real sum = 0;
    const int first = std::max({0, l2 - l3 - m1, l1 - l3 + m2});
    const int last = std::min({l1 + l2 - l3, l1 - m1, l2 + m2});
    for (int k = first; k <= last; ++k) {
        const Real term = 1 / (f(k) * f(l3 - l2 + k + m1) * f(l3 - l1 + k - m2) * f(l1 + l2 - l3 - k) *
                               f(l1 - k - m1) * f(l2 - k + m2));
        sum += k % 2 == 0 ? term : Real(-term);
    }
    const double value = static_cast<double>(Real(sqrt(triangle * outer) * sum));
    return (l1 - l2 - m3) % 2 == 0 ? value : -value;
}

nicol::PshVector random_field(std::mt19937_64& random, int order, int channels) {
    std::normal_distribution<double> normal;
    nicol::PshVector field(order, channels);
    for (int c = 0; c < channels; ++c) {
        const auto f = field.channel(c);
        for (std::size_t i = 0; i < f.size(); ++i)
            if (i % 4 == 0 || i % 4 == 3 || i / 4 >= nicol::psh_index(2, -2)) f[i] = normal(random);
    }
    return field;
}

glm::dmat3 random_rotation(std::mt19937_64& random) {
    std::uniform_real_distribution<double> uniform;
    const double a = 2 * std::numbers::pi * uniform(random);
    const double c = 2 * std::numbers::pi * uniform(random);
    return about_z(a) * about_y(std::acos(1 - 2 * uniform(random))) * about_z(c);
}

glm::dmat3 about_z(double t) {
    return {{std::cos(t), std::sin(t), 0}, {-std::sin(t), std::cos(t), 0}, {0, 0, 1}};
}

glm::dmat3 about_y(double t) {
    return {{std::cos(t), 0, -std::sin(t)}, {0, 1, 0}, {std::sin(t), 0, std::cos(t)}};
}

nicol::Frame theta_phi(const glm::dvec3& d) {
    const double theta = std::atan2(std::hypot(d.x, d.y), d.z);
    const double phi = std::atan2(d.y, d.x);
    return {direction(theta + std::numbers::pi / 2, phi), {-std::sin(phi), std::cos(phi), 0}, d};
}

std::complex<double> frame_change(const nicol::Frame& from, const nicol::Frame& to) {
    return std::polar(1.0, -2 * std::atan2(glm::dot(to[0], from[1]), glm::dot(to[0], from[0])));
}

}  // namespace reference
