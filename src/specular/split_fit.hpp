// SPDX-License-Identifier: MIT
// Least squares behind HighOrderFactors.
#pragma once

#include <array>
#include <vector>

#include "material/material.hpp"
#include "specular/lobe_tap.hpp"

namespace nicol {

/// The stencil of HighOrderFactors.
struct SplitStencil {
    int central;  ///< lobes, positions in kLobeWidths
    int outer;
    double spread;     ///< radians
    bool base = true;  ///< whether the last tap counts

    static constexpr std::size_t kCount = 6;
    /// Central, up, down, right, left, base in the surface's frame, for outgoing light at azimuth 0.
    [[nodiscard]] std::array<Tap, kCount> taps(double theta_out) const;
};

/// Unknowns: (tap, component) of the first five taps, then s0 of the last.
inline constexpr std::size_t kSplitUnknowns = 21;
using SplitVector = std::array<double, kSplitUnknowns>;

/// Factors for the four components of outgoing light, in the s-frame (x = n x v), and how much of the
/// response's energy they catch: [outgoing component][incident s0, (s1, s2), s3].
struct SplitFactors {
    std::array<SplitVector, 4> of{};
    std::array<std::array<double, 3>, 4> energy{};
};

/// The fit for materials at outgoing angles. The response is weighted by 1 / (l (l + 1)), as the power of
/// natural light is.
class SplitFit {
public:
    /// The weight of an order's energy.
    [[nodiscard]] static double prior(int l) { return l == 0 ? 0 : 1 / (l * (l + 1.0)); }

    /// `material` must outlive the object.
    SplitFit(const Material& material, int l_low, int l_high, int channels);

    /// Factors [channel] at theta_out in [0, pi/2). Calls may run side by side.
    [[nodiscard]] std::vector<SplitFactors> at(double theta_out, const SplitStencil& stencil) const;

private:
    using Moments = std::array<SplitVector, 4>;

    [[nodiscard]] std::vector<Moments> moments(double theta_out,
                                               const std::array<Tap, SplitStencil::kCount>& taps) const;
    [[nodiscard]] std::vector<Moments> integrated(double theta_out,
                                                  const std::array<Tap, SplitStencil::kCount>& taps) const;
    [[nodiscard]] std::vector<Moments> of_matrices(double theta_out,
                                                   const std::array<Tap, SplitStencil::kCount>& taps) const;

    const Material& material_;
    int l_low_;
    int l_high_;
    int channels_;
    std::vector<std::vector<double>> gains_;     // [lobe][l], times light's prior
    std::vector<std::vector<double>> products_;  // [lobe][lobe][l], of two lobes and the prior
    std::vector<ZonalKernel> kernels_;           // of gains_
};

}  // namespace nicol
