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
/// Largest value of such a texture, less the least.
inline constexpr double kFilmRange = 1 - kThinnestFilm;

/// Returns the texture of with_film_thickness() whose films are thinnest where the first channel of
/// `thickness` is 0 or less and thickest where it is 1 or more. Throws what affine_texture() throws.
[[nodiscard]] TexturePtr film_texture(const TexturePtr& thickness);

/// Returns make(film) for a film whose thickness follows the first channel of a texture, clamped to
/// kThinnestFilm..1: `least` nm at kThinnestFilm, thickest.thickness at 1, linear between. Interpolates
/// between up to 25 thicknesses, whose films differ by a phase of at most 0.8 radians at the shortest
/// wavelength unless the thicknesses are too many; exact for a texture of up to 16 values. Throws what make()
/// throws, and Error(invalid_argument) if the film or `least` is out of range.
[[nodiscard]] MaterialPtr with_film_thickness(
    const std::function<MaterialPtr(const FilmParameters& film)>& make, const FilmParameters& thickest,
    double least, const TexturePtr& thickness);

}  // namespace nicol
