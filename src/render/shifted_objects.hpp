// SPDX-License-Identifier: MIT
// Objects that a change of a scene has shifted.
#pragma once

#include <vector>

#include "stage/options.hpp"
#include "surfaces/scene_geometry.hpp"
#include "visibility/bake.hpp"

namespace nicol {

/// Returns whether vertices are traced anew that a change hides no other light from. What bounces to a vertex
/// changes with what hides the light from it, not only with how much does.
[[nodiscard]] bool traces_all(const RenderOptions& options);

/// Returns the shifted objects of a change, valid as long as the change. every_ray: whether the rays of such
/// objects are traced anew; if so, there are none.
[[nodiscard]] std::vector<ShiftedObject> shifted_objects(const SceneGeometry::Change& change, bool every_ray);

}  // namespace nicol
