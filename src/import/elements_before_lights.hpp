// SPDX-License-Identifier: MIT
// Polarization elements before lights without a surface.
#pragma once

#include "import/scene_description.hpp"
#include "import/scene_files.hpp"
#include "scene/scene.hpp"

namespace nicol::scene {

/// Replaces the state and the brightness of the lights of a scene by those of their light behind the elements
/// that cover them, in the order in which the light meets the elements. An element covers
/// - a spot or a projector if all of its cone or pyramid passes through the element,
/// - a directional or a point light if all that it may light, the boxes around shapes that are not black,
///   lies behind the element, seen from the light.
/// Elements with textures, and those that the light meets after them, change no light.
/// The state is that of light along the axis of a spot or a projector, and that of light towards the middle
/// of these boxes for a point light. scene: complete scene of the description; its elements stay. One notice
/// says what elements have no effect on; another names the first light of which an element covers only a
/// part. Throws as LoadBudget::check_time().
void put_elements_before_lights(const SceneDescription& description, Scene& scene, SceneFiles& files);

}  // namespace nicol::scene
