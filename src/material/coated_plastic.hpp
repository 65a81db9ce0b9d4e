// SPDX-License-Identifier: MIT
// Plastic whose boundary has a thin film.
#pragma once

#include "material/film.hpp"
#include "material/material.hpp"

namespace nicol {

/// Returns pplastic() with a film on the boundary: the facets reflect and the base is lit through the
/// interface with the film. The plastic itself without a film. Throws what pplastic() and FilmTable throw.
[[nodiscard]] MaterialPtr coated_pplastic(const PplasticParameters& parameters, const FilmParameters& film);

}  // namespace nicol
