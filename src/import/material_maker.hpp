// SPDX-License-Identifier: MIT
// Makes the materials of a scene, while it is loaded.
#pragma once

#include "import/material_description.hpp"
#include "import/scene_color.hpp"
#include "import/scene_files.hpp"
#include "import/scene_textures.hpp"

namespace nicol {

/// The channels of a scene's light, its textures and its files; they must outlive this.
struct MaterialMaker {
    const SceneChannels& channels;
    scene::SceneTextures& textures;
    scene::SceneFiles& files;

    /// Throws as MaterialModel::make().
    [[nodiscard]] MaterialPtr make(const MaterialDescription& description) const;

    [[nodiscard]] ColorParameter color(const TexturedColor& color) const;
    [[nodiscard]] NumberParameter number(const TexturedNumber& number) const;
};

}  // namespace nicol
