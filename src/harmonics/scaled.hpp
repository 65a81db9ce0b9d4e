// SPDX-License-Identifier: MIT
// Numbers far below the range of double, and the first value d^l_{mn} of a recursion over l.
#pragma once

#include <cmath>
#include <cstdlib>

#include "harmonics/require.hpp"

namespace nicol {

inline constexpr double kScaleUp = 0x1p256;
inline constexpr double kScaleDown = 0x1p-256;

/// Number v * 2^(256 e) with e <= 0, 2^-256 <= |v| unless v is zero, and |v| < 1 if e < 0. Harmonics near a
/// pole start far below the smallest double and still grow to order one, so their recursions use Scaled.
struct Scaled {
    double v = 0;
    int e = 0;

    Scaled() = default;
    explicit Scaled(double value) : v(value) { settle(); }

    Scaled& operator*=(const Scaled& o) {
        v *= o.v;
        e += o.e;
        settle();
        return *this;
    }
    Scaled& operator*=(double factor) {
        v *= factor;
        settle();
        return *this;
    }

    /// Multiplies by o * factor in one step, for a factor of moderate size.
    void multiply(const Scaled& o, double factor) {
        v *= o.v * factor;
        e += o.e;
        settle();
    }

    /// Returns the factor that converts v to the value; 0 if the factor would underflow.
    [[nodiscard]] double factor() const { return e == 0 ? 1.0 : e < -4 ? 0.0 : std::ldexp(1.0, 256 * e); }

private:
    void settle() {
        while (v != 0 && std::abs(v) < kScaleDown) {
            v *= kScaleUp;
            --e;
        }
        while (e < 0 && std::abs(v) >= 1) {
            v *= kScaleDown;
            ++e;
        }
    }
};

/// Sine and cosine of half the colatitude.
struct HalfAngle {
    double sin;
    double cos;
};

/// Returns d^l_{mn} at l = max(|m|, |n|): (-1)^(m-n) if m > n, times sqrt(binomial(2l, |m+n|)) cos^|m+n|
/// sin^|m-n|.
inline Scaled first_value(int m, int n, const HalfAngle& half) {
    const int a = std::abs(m + n);
    const int b = std::abs(m - n);
    const Scaled cos(half.cos);
    const Scaled sin(half.sin);
    Scaled value(m > n ? parity(b) : 1.0);
    // Binomials and powers are interleaved, so that neither leaves the range of double.
    for (int k = 1; k <= a; ++k) {
        value *= cos;
        value *= std::sqrt(static_cast<double>(b + k) / k);
    }
    for (int k = 0; k < b; ++k) value *= sin;
    return value;
}

/// Returns the ratio of d^{m+1}_{m+1,n} to d^m_{mn} for m >= |n|, without the factor -sin cos.
inline double next_first_ratio(int m, int n) {
    const double k = m + 1;
    return std::sqrt((2 * k) * (2 * k - 1) / ((k + n) * (k - n)));
}

}  // namespace nicol
