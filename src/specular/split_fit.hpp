// SPDX-License-Identifier: MIT
// Least-squares fit of HighOrderFactors.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "material/material.hpp"
#include "specular/lobe_tap.hpp"
#include "specular/tap_moments.hpp"

namespace nicol {

/// Stencil of HighOrderFactors.
struct SplitStencil {
    int central;  ///< lobe of the central tap, index in kLobeWidths; so is `outer` of the outer taps
    int outer;
    double spread;     ///< angle between the central and the outer taps, radians
    bool base = true;  ///< whether there is a base tap

    static constexpr std::size_t kCount = 6;
    /// Returns central, up, down, right, left and base in the surface's frame, for outgoing light at azimuth
    /// 0.
    [[nodiscard]] std::array<Tap, kCount> taps(double theta_out) const;
};

/// Number of unknowns: (tap, component) of the first five taps, then s0 of the last.
inline constexpr std::size_t kSplitUnknowns = 21;
using SplitVector = std::array<double, kSplitUnknowns>;

/// Factors for the four components of outgoing light, in the s-frame (x = n x v), and the energy of the
/// response that they represent: [outgoing component][incident s0, (s1, s2), s3].
struct SplitFactors {
    std::array<SplitVector, 4> of{};
    std::array<std::array<double, 3>, 4> energy{};
};

/// Fit for materials at outgoing angles. The response is weighted by 1 / (l (l + 1)), like the power of
/// natural light.
class SplitFit {
public:
    /// Returns the weight of an order's energy.
    [[nodiscard]] static double prior(int l) { return l == 0 ? 0 : 1 / (l * (l + 1.0)); }

    /// Keeps a reference to `material`, which must outlive the object.
    SplitFit(const Material& material, int l_low, int l_high, int channels);

    /// Returns the factors [stencil][channel] at theta_out in [0, pi/2). Stencils share most of the work.
    /// Calls may run side by side.
    [[nodiscard]] std::vector<std::vector<SplitFactors>> at(double theta_out,
                                                            std::span<const SplitStencil> stencils) const;

private:
    // Projections of the response onto taps, [tap][channel]; see half_.
    using Moments = std::vector<std::vector<TapRows>>;

    [[nodiscard]] Moments integrated(double theta_out, std::span<const Tap> taps) const;
    [[nodiscard]] Moments of_matrices(double theta_out, std::span<const Tap> taps) const;
    // `projections`: of the stencil's taps, [tap].
    [[nodiscard]] std::vector<SplitFactors> solved(
        const SplitStencil& stencil, const std::array<Tap, SplitStencil::kCount>& taps,
        const std::array<const std::vector<TapRows>*, SplitStencil::kCount>& projections) const;

    const Material& material_;
    int l_low_;
    int l_high_;
    int channels_;
    bool half_;                                  // whether integrated() covers half the circle of azimuths
    std::vector<std::vector<double>> gains_;     // gains times the prior, [lobe][l]
    std::vector<std::vector<double>> products_;  // [lobe][lobe][l], gains of two lobes and prior
    std::vector<ZonalKernel> kernels_;           // kernels of gains_
};

}  // namespace nicol
