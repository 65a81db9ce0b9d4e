// SPDX-License-Identifier: MIT
// Dot products of the shade step, for sixteen vertices at once.
#pragma once

#include <cstddef>

#include "harmonics/light_layout.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// Computes stokes[p] for p < rows (1, 3 or 4): the response of `table`, [p][pairing][pair], to light for a
/// viewer at azimuth phi. cosine[m] and sine[m] are those of m phi. pairings: 1 or 2.
void respond(const LightLayout& layout, std::size_t rows, std::size_t pairings, const Lanes* table,
             const Lanes* light, const Lanes* cosine, const Lanes* sine, Lanes* stokes);

}  // namespace nicol
