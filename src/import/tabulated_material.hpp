// SPDX-License-Identifier: MIT
// <bsdf>s that are a table in a file.
#pragma once

#include <filesystem>
#include <optional>

#include "import/material_description.hpp"
#include "import/texture_specification.hpp"

namespace nicol::scene {

/// A material of a file.
struct TabulatedModel : MaterialModel {
    std::filesystem::path filename;
    TexturedColor scale{1.0};  ///< without a table over the wavelength
    bool symmetrize = false;   ///< without what breaks mirror symmetry
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
