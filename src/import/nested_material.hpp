// SPDX-License-Identifier: MIT
// <bsdf>s made of others and a texture, which is not null.
#pragma once

#include <utility>

#include "import/material_description.hpp"
#include "import/texture_specification.hpp"
#include "material/mixture.hpp"

namespace nicol::scene {

/// A material that a texture varies.
struct VariedModel : MaterialModel {
    VariedModel(MaterialDescription of, TextureSpecificationPtr by)
        : base(std::move(of)), texture(std::move(by)) {}

    MaterialDescription base;
    TextureSpecificationPtr texture;
};

/// The texture has the normals.
struct NormalMapModel final : VariedModel {
    using VariedModel::VariedModel;
    MapOptions options;

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

/// The texture has the heights.
struct BumpMapModel final : VariedModel {
    using VariedModel::VariedModel;
    double scale = 1.0;  ///< times the heights
    MapOptions options;

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

/// The texture has the opacity.
struct MaskModel final : VariedModel {
    using VariedModel::VariedModel;
    bool translucent = true;  ///< see SpatialVariation

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

/// The base where the texture is 0, `other` where the texture is 1.
struct BlendModel final : VariedModel {
    BlendModel(MaterialDescription first, MaterialDescription second, TextureSpecificationPtr weight)
        : VariedModel(std::move(first), std::move(weight)), other(std::move(second)) {}

    MaterialDescription other;

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

}  // namespace nicol::scene
