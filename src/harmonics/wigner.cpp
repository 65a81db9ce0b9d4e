// SPDX-License-Identifier: MIT
#include "harmonics/wigner.hpp"

#include "harmonics/wigner_sweep.hpp"

namespace nicol {
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
