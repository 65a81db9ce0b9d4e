// SPDX-License-Identifier: MIT
#include "harmonics/wigner.hpp"

#include <algorithm>
#include <utility>

namespace nicol {

WignerSweep::WignerSweep(int order, HalfAngle half)
    : half_(half),
      current_(psh_count(order)),
      previous_(psh_count(order)),
      exponent_(psh_count(order)),
      unsettled_(static_cast<std::size_t>(order) + 1),
      root_(static_cast<std::size_t>(order) + 2),
      next_root_(static_cast<std::size_t>(order) + 2),
      change_(static_cast<std::size_t>(order) + 1),
      edge_(1) {
    current_[0] = 1;
}

/// Computes d^m_{mn} for n = -m..m, outwards from the larger of d_{mm} = cos^2m and |d_{m,-m}| = sin^2m.
void WignerSweep::start_row(int m) {
    const double large = north() ? half_.cos : half_.sin;
    edge_ *= Scaled(large);
    edge_ *= Scaled(large);
    const double ratio = -(north() ? half_.sin / half_.cos : half_.cos / half_.sin);
    Scaled value = edge_;
    const Scaled step(ratio);
    unsettled_[static_cast<std::size_t>(m)] = 0;
    change_[static_cast<std::size_t>(m)] = 0;
    // South: d_{m,-m} = (-1)^(2m) sin^2m, and the sign alternates with n as in the north.
    for (int k = 0; k <= 2 * m; ++k) {
        const std::size_t i = psh_index(m, north() ? m - k : k - m);
        current_[i] = value.v;
        previous_[i] = 0;
        // Beyond this depth an entry cannot grow back to a value that counts.
        exponent_[i] = static_cast<std::int16_t>(std::max(value.e, -30000));
        if (value.e != 0) ++unsettled_[static_cast<std::size_t>(m)];
        if (k == 2 * m) break;
        value *= step;
        value *= std::sqrt((2.0 * m - k) / (k + 1.0));
    }
}

void WignerSweep::rescale_row(int m) {
    for (int n = -m; n <= m; ++n) {
        const std::size_t i = psh_index(m, n);
        if (exponent_[i] < 0 && std::abs(current_[i]) > 0x1p100) {
            current_[i] *= kScaleDown;
            previous_[i] *= kScaleDown;
            if (++exponent_[i] != 0) continue;
            --unsettled_[static_cast<std::size_t>(m)];
            if (n == (north() ? m : -m))
                change_[static_cast<std::size_t>(m)] = current_[i] - (north() ? 1 : -1) * previous_[i];
        }
    }
}

void WignerSweep::step() {
    const double l = l_;
    const double k = l + 1;
    for (int n = 0; n <= l_ + 1; ++n) {
        root_[static_cast<std::size_t>(n)] = std::sqrt((l - n) * (l + n) * (n <= l_ ? 1 : 0));
        next_root_[static_cast<std::size_t>(n)] = n <= l_ ? 1 / std::sqrt((k - n) * (k + n)) : 0;
    }
    const double side = north() ? 1 : -1;
    const double small = 2 * (north() ? half_.sin * half_.sin : half_.cos * half_.cos);
    const double ll = l * k;
    if (l_ == 0) {
        change_[0] = -side * small;
        current_[0] = side * (1 - small);
        previous_[0] = 1;
    } else {
        for (int m = 0; m <= l_; ++m) {
            const auto row = static_cast<std::size_t>(m);
            const double up = next_root_[row] / l;
            const double a = (2 * l + 1) * up * side;
            const double b = k * root_[row] * up;
            const double shift = side * m;
            double* now = &current_[psh_index(m, 0)];
            double* before = &previous_[psh_index(m, 0)];
            const double* root = root_.data();
            const double* inverse = next_root_.data();
            for (int n = 0; n <= m; ++n)
                before[n] =
                    (a * ((ll - shift * n) - ll * small) * now[n] - b * root[n] * before[n]) * inverse[n];
            for (int n = 1; n <= m; ++n)
                before[-n] =
                    (a * ((ll + shift * n) - ll * small) * now[-n] - b * root[n] * before[-n]) * inverse[n];
            // The entry at the pole stays near one beside the pole and would accumulate rounding errors (see
            // run_pole_degree()).
            const std::size_t pole = psh_index(m, north() ? m : -m);
            if (exponent_[pole] == 0) {
                const double inward = root_[row] * next_root_[row];
                const double value = current_[pole];
                const double change = k / l * inward * inward * change_[row] -
                                      (2 * l + 1) * k * next_root_[row] * next_root_[row] * small * value;
                previous_[pole] = side * (value + change);
                change_[row] = side * change;
            }
        }
        std::swap(current_, previous_);
        for (int m = 0; m <= l_; ++m)
            if (unsettled_[static_cast<std::size_t>(m)] > 0) rescale_row(m);
    }
    ++l_;
    start_row(l_);
}

void WignerSweep::block(double* out) const {
    const int width = 2 * l_ + 1;
    double* centre = out + static_cast<std::ptrdiff_t>(l_) * width + l_;
    for (int m = 0; m <= l_; ++m) {
        const bool scaled = unsettled_[static_cast<std::size_t>(m)] > 0;
        for (int n = -m; n <= m; ++n) {
            const std::size_t i = psh_index(m, n);
            double value = current_[i];
            if (scaled && exponent_[i] < 0)
                value = exponent_[i] < -4 ? 0 : std::ldexp(value, 256 * exponent_[i]);
            const double rotated = parity(m - n) * value;
            centre[m * width + n] = value;
            centre[-n * width - m] = value;
            centre[n * width + m] = rotated;
            centre[-m * width - n] = rotated;
        }
    }
}

namespace {

/// Half angle folded to non-negative functions, which Scaled values need. d at a negative angle or an angle
/// beyond pi differs from d in [0, pi] by signs only.
struct Folded {
    HalfAngle half;
    bool alternate;  ///< whether the factor (-1)^(m - n) applies: d(-beta)
};

Folded folded(double beta) {
    require(std::isfinite(beta), "beta is not finite");
    // The period is 2 pi for integer orders, because (s, c) and (-s, -c) are one rotation.
    const double s = std::sin(beta / 2);
    const double c = std::cos(beta / 2);
    return {{std::abs(s), std::abs(c)}, (s < 0) != (c < 0)};
}

void alternate_signs(int l, double* block) {
    const int width = 2 * l + 1;
    for (int i = 1; i < width * width; i += 2) block[i] = -block[i];
}

}  // namespace

std::vector<double> wigner_d(int order, double beta) {
    require(order >= 0 && order <= kMaxWignerOrder,
            "order is " + std::to_string(order) + ", expected 0 to " + std::to_string(kMaxWignerOrder));
    const Folded angle = folded(beta);
    std::vector<double> out(wigner_offset(order + 1));
    WignerSweep sweep(order, angle.half);
    for (int l = 0;; ++l) {
        double* block = out.data() + wigner_offset(l);
        sweep.block(block);
        if (angle.alternate) alternate_signs(l, block);
        if (l == order) return out;
        sweep.step();
    }
}

}  // namespace nicol
