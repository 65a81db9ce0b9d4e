// SPDX-License-Identifier: MIT
// The materials of a scene, while it is loaded.
#pragma once

#include "import/scene_color.hpp"
#include "import/scene_description.hpp"
#include "import/scene_files.hpp"
#include "import/scene_textures.hpp"
#include "material/material.hpp"

namespace nicol::scene {

/// Throws what reading its files and the makers of src/material throw, and Error(unsupported) for colours
/// that the scene's channels cannot have.
[[nodiscard]] MaterialPtr make_material(const MaterialDescription& description, const SceneChannels& channels,
                                        SceneTextures& textures, SceneFiles& files);

/// Of a material of kind principled.
[[nodiscard]] MaterialPtr make_principled(const PrincipledDescription& description,
                                          const SceneChannels& channels, SceneTextures& textures);

}  // namespace nicol::scene
