// SPDX-License-Identifier: MIT
// <bsdf>s made of other <bsdf>s and a texture, which is not null.
#pragma once

#include <utility>

#include "import/material_description.hpp"
#include "import/texture_specification.hpp"
#include "material/mixture.hpp"

namespace nicol::scene {

/// Material that a texture varies.
struct VariedModel : MaterialModel {
    VariedModel(MaterialDescription of, TextureSpecificationPtr by)
        : base(std::move(of)), texture(std::move(by)) {}

    MaterialDescription base;
    TextureSpecificationPtr texture;
};

/// Material whose normals are in the texture.
struct NormalMapModel final : VariedModel {
    using VariedModel::VariedModel;
    MapOptions options;

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

/// Material whose heights are in the texture.
struct BumpMapModel final : VariedModel {
    using VariedModel::VariedModel;
    double scale = 1.0;  ///< times the heights
    MapOptions options;

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

/// Material whose opacity is in the texture.
struct MaskModel final : VariedModel {
    using VariedModel::VariedModel;
    bool translucent = true;  ///< see SpatialVariation

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

/// Blend of two materials: the base where the texture is 0, `other` where the texture is 1.
struct BlendModel final : VariedModel {
    BlendModel(MaterialDescription first, MaterialDescription second, TextureSpecificationPtr weight)
        : VariedModel(std::move(first), std::move(weight)), other(std::move(second)) {}

    MaterialDescription other;

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

}  // namespace nicol::scene
