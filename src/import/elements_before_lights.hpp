// SPDX-License-Identifier: MIT
// Polarization elements before lights without a surface.
#pragma once

#include "import/scene_description.hpp"
#include "import/scene_files.hpp"
#include "scene/scene.hpp"

namespace nicol::scene {

/// Gives the lights of a scene the state and the brightness of their light behind the elements that cover
/// them, in the order in which it meets them. An element covers
/// - a spot or a projector if all of its cone or pyramid passes through the element,
/// - a directional or a point light if all that it may light, the boxes around shapes that are not black,
///   lies behind the element, seen from the light.
/// The state is that of light along the axis of a spot or a projector, of a point light towards the middle of
/// these boxes. The scene is that of the description, complete; its elements stay. Notices say what elements
/// do not do, once, and where light passes beside one that only covers a part, of the first such light.
/// Throws as LoadBudget::check_time().
void put_elements_before_lights(const SceneDescription& description, Scene& scene, SceneFiles& files);

}  // namespace nicol::scene
