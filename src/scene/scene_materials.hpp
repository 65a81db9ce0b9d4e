// SPDX-License-Identifier: MIT
// The materials of a scene, while it is loaded.
#pragma once

#include "material/material.hpp"
#include "scene/scene_color.hpp"
#include "scene/scene_description.hpp"
#include "scene/scene_files.hpp"
#include "scene/scene_textures.hpp"

namespace nicol::scene {

/// Throws what reading its files and the makers of src/material throw, and Error(unsupported) for colours
/// that the scene's channels cannot have.
[[nodiscard]] MaterialPtr make_material(const MaterialDescription& description, const SceneChannels& channels,
                                        SceneTextures& textures, SceneFiles& files);

/// Of a material of kind principled.
[[nodiscard]] MaterialPtr make_principled(const PrincipledDescription& description,
                                          const SceneChannels& channels, SceneTextures& textures);

}  // namespace nicol::scene
