// SPDX-License-Identifier: MIT
// Reflection and transmission of a slab with smooth, parallel sides.
#pragma once

#include "polarization/mueller.hpp"

namespace nicol {

/// Mueller matrices of a slab. All frames have x along the s-axis and z along the propagation.
struct SlabSplit {
    Mueller reflection;
    Mueller transmission;
};

/// Returns the light that a slab of relative index eta > 0 reflects and transmits, for cosines of 0 to 1. The
/// slab absorbs nothing. All reflections inside the slab are summed without interference.
[[nodiscard]] SlabSplit slab_split(double cos_incident, double eta);

}  // namespace nicol
