// SPDX-License-Identifier: MIT
// Reflection of the light at the taps of a material's stencil, for sixteen vertices at once.
#pragma once

#include "simd/lanes.hpp"
#include "specular/lane_mirror.hpp"

namespace nicol {

/// One channel of the light at the taps of HighOrderFactors: one number per tap if it is unpolarized, else
/// four.
struct ChannelTaps {
    const Lanes* central;
    const Lanes* up;  ///< null if there are no outer taps, as are down, right and left
    const Lanes* down;
    const Lanes* right;
    const Lanes* left;
    const Lanes* base;  ///< null if there is no base tap
};

/// Computes Stokes vectors in the camera's frame field. factors: [pairing][element]. lobe and hemisphere: the
/// visible fractions.
void reflect_taps(const ChannelTaps& taps, bool polarized, const Lanes* factors, std::size_t pairings,
                  const LaneMirror& mirror, const Lanes& lobe, const Lanes& hemisphere, Lanes* stokes);

}  // namespace nicol
