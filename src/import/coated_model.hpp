// SPDX-License-Identifier: MIT
// Plastic with a film, as a scene file describes it.
#pragma once

#include <utility>

#include "import/late_parameters.hpp"
#include "material/film.hpp"

namespace nicol::scene {

/// A coated_pplastic().
struct CoatedPlasticModel final : MaterialModel, LateParameters<PplasticParameters> {
    CoatedPlasticModel(LateParameters<PplasticParameters> plastic, FilmParameters on_boundary)
        : LateParameters(std::move(plastic)), film(std::move(on_boundary)) {}

    FilmParameters film;

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

}  // namespace nicol::scene
