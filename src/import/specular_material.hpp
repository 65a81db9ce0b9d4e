// SPDX-License-Identifier: MIT
// Materials as glTF describes them by specular colour and glossiness (KHR_materials_pbrSpecularGlossiness).
#pragma once

#include <utility>

#include "import/material_maker.hpp"

namespace nicol::scene {

/// The sum of a plastic times a colour and of a mirror.
struct SpecularModel final : MaterialModel {
    SpecularModel(MaterialDescription of, TextureSpecificationPtr times, MaterialDescription and_mirror)
        : plastic(std::move(of)), share(std::move(times)), mirror(std::move(and_mirror)) {}

    MaterialDescription plastic;
    TextureSpecificationPtr share;  ///< factor of the plastic; not null
    MaterialDescription mirror;

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

}  // namespace nicol::scene
