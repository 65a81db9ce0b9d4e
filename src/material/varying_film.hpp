// SPDX-License-Identifier: MIT
// Thin films whose thickness varies over a surface.
#pragma once

#include <functional>

#include "material/film.hpp"
#include "material/material.hpp"
#include "texture/texture.hpp"

namespace nicol {

/// Value of a texture where a film is thinnest. Thicknesses are interpolated in the inverse of the value, so
/// the smaller its range, the more evenly they lie.
inline constexpr double kThinnestFilm = 0.5;

/// Returns make(film) for a film whose thickness follows the first channel of a texture, clamped to
/// kThinnestFilm..1: `least` nm at kThinnestFilm, thickest.thickness at 1, linear between. Interpolates
/// between up to 25 thicknesses, whose films differ by a phase of at most 0.8 radians at the shortest
/// wavelength unless the thicknesses are too many; exact for a texture of up to 16 values. Throws what make()
/// throws, and Error(invalid_argument) if `least` is no thickness of a film.
[[nodiscard]] MaterialPtr with_film_thickness(
    const std::function<MaterialPtr(const FilmParameters& film)>& make, const FilmParameters& thickest,
    double least, const TexturePtr& thickness);

}  // namespace nicol
