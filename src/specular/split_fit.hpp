// SPDX-License-Identifier: MIT
// Least-squares fit of HighOrderFactors.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <mutex>
#include <span>
#include <tuple>
#include <vector>

#include "material/material.hpp"
#include "specular/known_moments.hpp"
#include "specular/lobe_tap.hpp"
#include "specular/tap_moments.hpp"

namespace nicol {

/// Stencil of HighOrderFactors.
struct SplitStencil {
    int central;  ///< lobe of the central tap, index in kLobeWidths; so is `outer` of the outer taps
    int outer;
    double spread;     ///< angle between the central and the outer taps, radians: the outer lobe's width
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

/// Lobes of taps for the orders l_low + 1 .. l_high, which the fits of all materials share. The response is
/// weighted by 1 / (l (l + 1)), like the power of natural light.
class SplitBasis {
public:
    /// Returns the weight of an order's energy.
    [[nodiscard]] static double prior(int l) { return l == 0 ? 0 : 1 / (l * (l + 1.0)); }

    /// Throws Error(invalid_argument) for orders out of 0 <= l_low < l_high <= kMaxOrder.
    SplitBasis(int l_low, int l_high);

    [[nodiscard]] int l_low() const noexcept { return l_low_; }
    [[nodiscard]] int l_high() const noexcept { return l_high_; }
    /// Returns a lobe's gains times the prior, by order.
    [[nodiscard]] std::span<const double> gains(int lobe) const {
        return gains_[static_cast<std::size_t>(lobe)];
    }
    /// Returns the product of the gains of two lobes and the prior, by order.
    [[nodiscard]] const std::vector<double>& product(int lobe, int other) const {
        return products_[static_cast<std::size_t>(lobe) * gains_.size() + static_cast<std::size_t>(other)];
    }
    /// Returns the Cholesky factor, row-major, of the products of a stencil's unknowns with each other. Calls
    /// may run side by side.
    [[nodiscard]] const std::vector<double>& factor(const SplitStencil& stencil, double theta_out) const;
    /// Returns the kernels of gains(), by lobe.
    [[nodiscard]] std::span<const ZonalKernel> kernels() const noexcept { return kernels_; }

private:
    int l_low_;
    int l_high_;
    std::vector<std::vector<double>> gains_;     // [lobe][l]
    std::vector<std::vector<double>> products_;  // [lobe][lobe][l]
    std::vector<ZonalKernel> kernels_;
    // Results of factor() by angle, central lobe, outer lobe, and whether there is a base tap.
    mutable std::mutex mutex_;
    mutable std::map<std::tuple<double, int, int, bool>, std::vector<double>> factors_;
};

/// Fit for a material at outgoing angles.
class SplitFit {
public:
    /// Keeps references, which must outlive the object. `known` holds moments of materials with the same
    /// terms_key(), for the same basis and columns. columns: 4, or 1 for the factors of s0 alone, which are
    /// all that unpolarized light needs; the others are then unspecified.
    SplitFit(const Material& material, const SplitBasis& basis, int channels, KnownMoments& known,
             std::size_t columns = 4);

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
        const SplitStencil& stencil, double theta_out,
        const std::array<const std::vector<TapRows>*, SplitStencil::kCount>& projections) const;

    const Material& material_;
    const SplitBasis& basis_;
    int channels_;
    std::size_t columns_;
    KnownMoments& known_;
    bool half_;  // whether integrated() covers half the circle of azimuths
};

}  // namespace nicol
