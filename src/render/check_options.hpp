// SPDX-License-Identifier: MIT
// Checks of the options of a render.
#pragma once

#include "scene/scene.hpp"
#include "stage/options.hpp"

namespace nicol {

/// Throws Error(invalid_argument) for options out of range and for more samples than an image of width x
/// height pixels can have. Throws Error(unsupported) for a method, a place of shading or a path length that
/// the options or the scene's materials do not allow.
void check(const RenderOptions& options, const Scene& scene, int width, int height);

}  // namespace nicol
