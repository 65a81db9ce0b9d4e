// SPDX-License-Identifier: MIT
// What a material reflects of the light at the taps of its stencil, sixteen vertices at once.
#pragma once

#include "simd/lanes.hpp"
#include "specular/lane_mirror.hpp"

namespace nicol {

/// One channel of the light at the taps of HighOrderFactors: a number each where it is unpolarized, else
/// four.
struct ChannelTaps {
    const Lanes* central;
    const Lanes* up;  ///< null where there are no outer taps; so are the next three
    const Lanes* down;
    const Lanes* right;
    const Lanes* left;
    const Lanes* base;  ///< null where there is none
};

/// Stokes vectors in the camera's frame field. factors: [pairing][element]. lobe and hemisphere: the visible
/// fractions.
void reflect_taps(const ChannelTaps& taps, bool polarized, const Lanes* factors, std::size_t pairings,
                  const LaneMirror& mirror, const Lanes& lobe, const Lanes& hemisphere, Lanes* stokes);

}  // namespace nicol
