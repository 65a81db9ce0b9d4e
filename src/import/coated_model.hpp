// SPDX-License-Identifier: MIT
// Plastic with a film, as a scene file describes it.
#pragma once

#include <utility>

#include "import/film_description.hpp"
#include "import/late_parameters.hpp"

namespace nicol::scene {

/// A coated_pplastic().
struct CoatedPlasticModel final : MaterialModel, LateParameters<PplasticParameters> {
    CoatedPlasticModel(LateParameters<PplasticParameters> plastic, FilmDescription on_boundary)
        : LateParameters(std::move(plastic)), film(std::move(on_boundary)) {}

    FilmDescription film;

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

}  // namespace nicol::scene
