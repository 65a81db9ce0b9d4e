// SPDX-License-Identifier: MIT
// Thin films of the C interface.
#pragma once

#include "assets.hpp"
#include "material/film.hpp"

namespace nicol::capi {

inline FilmParameters film_of(const nicol_film& given) {
    if (given.reserved != 0) refuse("film.reserved must be 0");
    return {.thickness = static_cast<double>(given.thickness),
            .eta = {{static_cast<double>(given.eta), -static_cast<double>(given.k)}},
            .wavelengths = spectrum(given.wavelengths, 0, 0, "film.wavelengths")};
}

}  // namespace nicol::capi
