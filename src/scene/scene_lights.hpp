// SPDX-License-Identifier: MIT
// The lights of a scene beside its environment, while it is loaded.
#pragma once

#include "light/small_light.hpp"
#include "scene/scene_color.hpp"
#include "scene/scene_description.hpp"
#include "scene/scene_textures.hpp"

namespace nicol::scene {

/// Both throw what reading textures throws, and Error(unsupported) for colours that the scene's channels
/// cannot have.
[[nodiscard]] SmallLight make_light(const LightDescription& description, const SceneChannels& channels,
                                    SceneTextures& textures);
[[nodiscard]] EmissionPtr make_emission(const EmissionDescription& description, const SceneChannels& channels,
                                        SceneTextures& textures);

}  // namespace nicol::scene
