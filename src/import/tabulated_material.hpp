// SPDX-License-Identifier: MIT
// Materials of scene files whose reflectance is a table in a file.
#pragma once

#include <filesystem>
#include <optional>

#include "import/material_description.hpp"
#include "import/texture_specification.hpp"

namespace nicol::scene {

/// Material whose table is in a file.
struct TabulatedModel : MaterialModel {
    std::filesystem::path filename;
    TexturedColor scale{1.0};  ///< factor; no table over the wavelength
    bool symmetrize = false;   ///< drop the part without mirror symmetry
};

/// A PSH matrix (.npz).
struct PshModel final : TabulatedModel {
    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

/// Mitsuba's measured_polarized (.pbsdf).
struct MeasuredModel final : TabulatedModel {
    std::optional<double> wavelength;  ///< the only one to use, nm; none: all of the table

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

}  // namespace nicol::scene
