// SPDX-License-Identifier: MIT
#include "polarization/slab.hpp"

#include "polarization/fresnel.hpp"

namespace nicol {

SlabSplit slab_split(double cos_incident, double eta) {
    const Mueller once = fresnel_reflection(cos_incident, eta);
    // Under total reflection, no light enters the slab.
    if (!(fresnel_transmission(cos_incident, eta)(0, 0) > 0)) return {.reflection = once, .transmission = {}};
    const SlabBlocks<double> blocks =
        slab_blocks(ReflectionBlock<double>{once(0, 0), once(0, 1), once(2, 2), 0});
    return {.reflection = mueller_of(blocks.reflection), .transmission = mueller_of(blocks.transmission)};
}

}  // namespace nicol
