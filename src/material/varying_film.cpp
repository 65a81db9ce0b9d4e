// SPDX-License-Identifier: MIT
#include "material/varying_film.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "material/mixture.hpp"
#include "material/reflectance.hpp"
#include "texture/affine_texture.hpp"

namespace nicol {
namespace {

// Phase of interference between neighbouring thicknesses of a film that varies, in radians at the shortest
// wavelength: between them, reflectances err by up to an eighth of its square times their amplitude.
constexpr double kPhaseStep = 0.8;
// Most steps of the thickness, because each has a table and a layer of its own.
constexpr double kMostSteps = 24;
// Wavelength of the shortest of the colours, nm.
constexpr double kShortestOfColours = 450;

}  // namespace

TexturePtr film_texture(const TexturePtr& thickness) {
    return affine_texture(thickness, static_cast<float>(kFilmRange), static_cast<float>(kThinnestFilm));
}

MaterialPtr with_film_thickness(const std::function<MaterialPtr(const FilmParameters& film)>& make,
                                const FilmParameters& thickest, double least, const TexturePtr& thickness) {
    check_film(thickest);
    check_range(least, 0, kThickestFilm, "least film_thickness");
    double index = 0;
    for (const std::complex<double> eta : thickest.eta) index = std::max(index, eta.real());
    double shortest = kShortestOfColours;
    if (!thickest.wavelengths.empty()) shortest = *std::ranges::min_element(thickest.wavelengths);
    const double phase = 4 * std::numbers::pi * index * std::abs(thickest.thickness - least) / shortest;
    const double steps = std::clamp(phase / kPhaseStep, 1.0, kMostSteps);
    const auto made = [&](double t) {
        FilmParameters film = thickest;
        film.thickness = least + (thickest.thickness - least) * (t - kThinnestFilm) / kFilmRange;
        return make(film);
    };
    return with_number(made, thickness, kThinnestFilm, std::pow(1 / kThinnestFilm, 1 / steps));
}

}  // namespace nicol
