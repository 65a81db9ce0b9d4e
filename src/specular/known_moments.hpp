// SPDX-License-Identifier: MIT
// Moments of terms that fits of several materials or stencils share.
#pragma once

#include <cstddef>
#include <map>
#include <mutex>
#include <span>
#include <tuple>
#include <vector>

#include "material/material.hpp"
#include "specular/lobe_tap.hpp"
#include "specular/tap_moments.hpp"

namespace nicol {

/// Results of tap_moments() for materials with equal terms_key(), and for the same kernels and columns. Calls
/// may run side by side.
class KnownMoments {
public:
    /// Returns tap_moments(). Computes it for the taps that no call has had at this angle. The taps are those
    /// of a SplitStencil.
    [[nodiscard]] std::vector<std::vector<TapRows>> at(const Material& material, double theta_out,
                                                       std::span<const Tap> taps,
                                                       std::span<const ZonalKernel> kernels,
                                                       std::size_t columns);

private:
    // Angle, lobe and direction of a tap, which determine the tap's frame.
    using Place = std::tuple<double, int, double, double>;
    std::mutex mutex_;
    std::map<Place, std::vector<TapRows>> known_;  // [term]
};

}  // namespace nicol
