// SPDX-License-Identifier: MIT
// What a material makes of probed light, sixteen vertices at once.
#pragma once

#include "simd/lanes.hpp"
#include "specular/lane_mirror.hpp"

namespace nicol {

/// One channel of the probes of HighOrderFactors: a number each where light is unpolarized, else four.
struct ProbedChannel {
    const Lanes* centre;
    const Lanes* up;  ///< null where only the centre is probed; so are the next three
    const Lanes* down;
    const Lanes* right;
    const Lanes* left;
    const Lanes* normal;  ///< null where there is none
};

/// Stokes vectors in the camera's frame field. factors: [element]. lobe and hemisphere: the visible
/// fractions.
void reflect_probes(const ProbedChannel& probed, bool polarized, const Lanes* factors,
                    const LaneMirror& mirror, const Lanes& lobe, const Lanes& hemisphere, Lanes* stokes);

}  // namespace nicol
