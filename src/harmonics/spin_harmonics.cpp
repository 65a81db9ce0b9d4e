// SPDX-License-Identifier: MIT
// Spin-weighted harmonics by a three-term recursion in l for each degree, after a first value in Scaled
// range.
#include "harmonics/spin_harmonics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "harmonics/scaled.hpp"

namespace nicol {
namespace {

using Norms = std::array<double, kMaxOrder + 1>;

/// Returns sqrt((2 l + 1) / (4 pi)) by order l. Roots and divisions take as long as the recursion, so they
/// are tabulated.
const Norms& norms() {
    static const Norms table = [] {
        Norms out{};
        for (std::size_t l = 0; l < out.size(); ++l)
            out[l] = std::sqrt((2 * static_cast<double>(l) + 1) / (4 * std::numbers::pi));
        return out;
    }();
    return table;
}

/// Factor l (l+1) cos(theta) - m n, computed without cancellation next to the poles.
class Factor {
public:
    Factor(const HalfAngle& half, int m, int n)
        : sign_(half.sin <= half.cos ? 1 : -1),
          mn_(sign_ * m * n),
          small_(2 * (sign_ > 0 ? half.sin * half.sin : half.cos * half.cos)) {}

    [[nodiscard]] double operator()(int l) const {
        const double ll = static_cast<double>(l) * (l + 1);
        return sign_ * ((ll - mn_) - ll * small_);
    }

private:
    double sign_;
    double mn_;
    double small_;
};

/// Runs the degree that does not vanish at the nearer pole, m = n in the north and m = -n in the south. There
/// the plain recursion accumulates its rounding errors, so this recursion runs on the differences of d from
/// one l to the next.
void run_pole_degree(int m, int order, const HalfAngle& half, double first, std::span<double> out) {
    const bool north = half.sin <= half.cos;
    const double small = north ? half.sin * half.sin : half.cos * half.cos;
    const double mm = static_cast<double>(m) * m;
    const double alternate = north ? 1 : -1;
    double value = first;
    double change = 0;
    double sign = 1;
    const Norms& norm = norms();
    for (int l = std::abs(m);; ++l) {
        out[psh_index(l, m)] = norm[static_cast<std::size_t>(l)] * sign * value;
        if (l == order) return;
        const double k = l + 1.0;
        const double root = k * k - mm;
        const double back = l == 0 ? 0 : k * (static_cast<double>(l) * l - mm) / (l * root);
        change = back * change - 2 * (2 * l + 1) * k / root * small * value;
        value += change;
        sign *= alternate;
    }
}

void run_degree(int m, int n, int order, const HalfAngle& half, Scaled current, std::span<double> out) {
    if (current.v == 0) return;
    if (m == (half.sin <= half.cos ? n : -n) && current.e == 0) {
        run_pole_degree(m, order, half, current.v, out);
        return;
    }
    const Factor factor(half, m, n);
    const double mm = static_cast<double>(m) * m;
    const double nn = static_cast<double>(n) * n;
    double previous = 0;
    double root = 0;  // sqrt((l^2 - m^2)(l^2 - n^2))
    double scale = current.factor();
    const Norms& norm = norms();
    for (int l = std::max(std::abs(m), std::abs(n));; ++l) {
        out[psh_index(l, m)] = norm[static_cast<std::size_t>(l)] * (current.v * scale);
        if (l == order) return;
        const double k = l + 1.0;
        double next;
        if (l == 0) {
            next = factor(1) / 2 * current.v;  // cos(theta); the general step is 0/0 here
            root = 0;
        } else {
            const double next_root = std::sqrt((k * k - mm) * (k * k - nn));
            next = ((2 * l + 1) * factor(l) * current.v - k * root * previous) / (l * next_root);
            root = next_root;
        }
        previous = current.v;
        current.v = next;
        if (current.e < 0 && std::abs(current.v) > 0x1p100) {
            current.v *= kScaleDown;
            previous *= kScaleDown;
            ++current.e;
            scale = current.factor();
        }
        if (l == 0) root = std::sqrt((1 - mm) * (1 - nn));
    }
}

}  // namespace

void spin_harmonics(int spin, int order, double sin_half, double cos_half, std::span<double> out) {
    require_order(order);
    require(std::abs(spin) <= kMaxSpin, "spin is " + std::to_string(spin) + ", expected -4 to 4");
    require_size(out.size(), psh_count(order), "out");
    require(sin_half >= 0 && cos_half >= 0 && std::abs(sin_half * sin_half + cos_half * cos_half - 1) < 1e-12,
            "sin_half and cos_half are not those of a colatitude in [0, pi]");
    std::ranges::fill(out, 0.0);
    const HalfAngle half{sin_half, cos_half};
    const int n = -spin;
    const int inner = std::abs(n);
    for (int m = -std::min(inner, order); m <= std::min(inner, order); ++m)
        if (inner <= order) run_degree(m, n, order, half, first_value(m, n, half), out);
    Scaled step(sin_half);
    step *= Scaled(cos_half);
    Scaled east = first_value(inner, n, half);
    Scaled west = first_value(-inner, n, half);
    for (int m = inner; m < order; ++m) {
        const double ratio = next_first_ratio(m, n);
        east *= step;
        east *= -ratio;
        run_degree(m + 1, n, order, half, east, out);
        if (n == 0) {
            // Degrees m and -m of scalars differ by the factor (-1)^m.
            const double sign = parity(m + 1);
            for (int l = m + 1; l <= order; ++l) out[psh_index(l, -m - 1)] = sign * out[psh_index(l, m + 1)];
            continue;
        }
        west *= step;
        west *= ratio;
        run_degree(-m - 1, n, order, half, west, out);
    }
    // Factor (-1)^s of Eq. 176.
    if (spin % 2 != 0)
        for (double& value : out) value = -value;
}

void spin_harmonics(int spin, int order, double theta, std::span<double> out) {
    require(theta >= 0 && theta <= std::numbers::pi,
            "theta is " + std::to_string(theta) + ", expected 0 to pi");
    spin_harmonics(spin, order, std::sin(theta / 2), std::cos(theta / 2), out);
}

namespace {

int order_of(std::size_t count) {
    const auto order = static_cast<int>(std::lround(std::sqrt(static_cast<double>(count)))) - 1;
    require(order >= 0 && order <= kMaxOrder && psh_count(order) == count,
            std::to_string(count) + " coefficients are no whole number of orders");
    return order;
}

}  // namespace

void real_from_complex(std::span<const std::complex<double>> coefficients,
                       std::span<std::complex<double>> out) {
    const int order = order_of(coefficients.size());
    require_size(out.size(), coefficients.size(), "out");
    const double half = std::numbers::sqrt2 / 2;
    for (int l = 0; l <= order; ++l) {
        out[psh_index(l, 0)] = coefficients[psh_index(l, 0)];
        for (int m = 1; m <= l; ++m) {
            const auto plus = coefficients[psh_index(l, m)];
            const auto minus = parity(m) * coefficients[psh_index(l, -m)];
            const auto difference = plus - minus;
            out[psh_index(l, m)] = half * (plus + minus);
            out[psh_index(l, -m)] = half * std::complex(-difference.imag(), difference.real());
        }
    }
}

void complex_from_real(std::span<const std::complex<double>> coefficients,
                       std::span<std::complex<double>> out) {
    const int order = order_of(coefficients.size());
    require_size(out.size(), coefficients.size(), "out");
    const double half = std::numbers::sqrt2 / 2;
    for (int l = 0; l <= order; ++l) {
        out[psh_index(l, 0)] = coefficients[psh_index(l, 0)];
        for (int m = 1; m <= l; ++m) {
            const auto cosine = coefficients[psh_index(l, m)];
            const auto sine = coefficients[psh_index(l, -m)];
            const std::complex rotated(-sine.imag(), sine.real());
            out[psh_index(l, m)] = half * (cosine - rotated);
            out[psh_index(l, -m)] = parity(m) * half * (cosine + rotated);
        }
    }
}

}  // namespace nicol
