// SPDX-License-Identifier: MIT
// Diffuse materials of scene files.
#pragma once

#include "import/material_description.hpp"
#include "import/texture_specification.hpp"

namespace nicol::scene {

/// Model of Mitsuba's diffuse.
struct DiffuseModel final : MaterialModel {
    TexturedColor reflectance{0.5};

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
    [[nodiscard]] bool black() const override;
};

}  // namespace nicol::scene
