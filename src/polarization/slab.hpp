// SPDX-License-Identifier: MIT
// Reflection and transmission of a slab with smooth, parallel sides.
#pragma once

#include "polarization/fresnel.hpp"
#include "polarization/mueller.hpp"

namespace nicol {

template <class Number>
struct SlabBlocks {
    ReflectionBlock<Number> reflection, transmission;
};

/// Returns the light that a slab reflects and transmits if each side reflects `once`, and not all light. All
/// reflections inside the slab are summed without interference.
template <class Number>
[[gnu::always_inline]] inline SlabBlocks<Number> slab_blocks(const ReflectionBlock<Number>& once) {
    // Both sides reflect the shares s, p and their correlation c, because the amplitudes differ only in sign.
    // The slab reflects r + t (r + r^3 + ...) t and transmits t (1 + r^2 + ...) t, with t^2 = 1 - r for s and
    // p, and t^2 = (1 - s)(1 - p) for the correlation.
    const Number s = once.a + once.b, p = once.a - once.b, c = once.c;
    const Number s_out = (1.0F - s) / (1.0F + s), p_out = (1.0F - p) / (1.0F + p);
    const Number c_out = (1.0F - s) * (1.0F - p) / (1.0F - c * c);
    const Number s_back = 2.0F * s / (1.0F + s), p_back = 2.0F * p / (1.0F + p);
    return {{0.5F * (s_back + p_back), 0.5F * (s_back - p_back), c + c * c_out, Number{}},
            {0.5F * (s_out + p_out), 0.5F * (s_out - p_out), c_out, Number{}}};
}

/// Mueller matrices of a slab. All frames have x along the s-axis and z along the propagation.
struct SlabSplit {
    Mueller reflection;
    Mueller transmission;
};

/// Returns the light that a slab of relative index eta > 0 reflects and transmits, for cosines of 0 to 1. The
/// slab absorbs nothing. All reflections inside the slab are summed without interference.
[[nodiscard]] SlabSplit slab_split(double cos_incident, double eta);

}  // namespace nicol
