// SPDX-License-Identifier: MIT
// Thin films of scene files.
#pragma once

#include <functional>
#include <utility>

#include "import/material_maker.hpp"
#include "material/varying_film.hpp"

namespace nicol {

/// Thin film, whose thickness may vary.
struct FilmDescription {
    FilmDescription() = default;
    FilmDescription(FilmParameters thickest) : film(std::move(thickest)) {}

    FilmParameters film;  ///< film, or the film of the largest thickness
    double least = 0;     ///< thickness where the texture is 0, nm
    TextureSpecificationPtr thickness =
        nullptr;  ///< thickness from `least` to film.thickness; null: constant

    [[nodiscard]] bool present() const { return film.present() || thickness != nullptr; }
};

/// Returns make() for the film of a description. Throws what make() and with_film_thickness() throw.
[[nodiscard]] MaterialPtr with_film(const MaterialMaker& maker, const FilmDescription& description,
                                    const std::function<MaterialPtr(const FilmParameters&)>& make);

}  // namespace nicol
