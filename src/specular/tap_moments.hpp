// SPDX-License-Identifier: MIT
// Projection of a material's response onto the filtered light at taps, by quadrature over incident
// directions.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "material/material.hpp"
#include "specular/lobe_tap.hpp"

namespace nicol {

/// Tap components: s0, s1, s2, s3 of the light at a tap.
using TapVector = std::array<double, 4>;
/// Projections of the rows of a Mueller matrix onto one tap, [outgoing component].
using TapRows = std::array<TapVector, 4>;

/// Returns the projections [tap][term] of a material's response at theta_out in [0, pi/2), outgoing azimuth
/// 0, onto taps. kernels: [lobe of a tap], the lobe's gains, weighted. The material is isotropic, and it is
/// evaluated once for all taps, sixteen directions at a time. If it is mirror-symmetric, the projections are
/// over light from azimuths 0 to pi only, one of two mirror images. columns: 4, or 1 for the projections of
/// s0 alone, which are all that unpolarized light needs; the others are then unspecified.
[[nodiscard]] std::vector<std::vector<TapRows>> tap_moments(const Material& material, double theta_out,
                                                            std::span<const Tap> taps,
                                                            std::span<const ZonalKernel> kernels,
                                                            std::size_t columns);

}  // namespace nicol
