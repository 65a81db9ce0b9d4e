// SPDX-License-Identifier: MIT
// Replacing a scene's light and material.
#pragma once

#include "stage.hpp"

enum class SceneVariant {
    original,     ///< the scene as it is
    polarized,    ///< rough plastic under a polarized sky, which needs all Stokes components
    unpolarized,  ///< diffuse surfaces of the same colour under the same sky, unpolarized
};

void apply_variant(Stage& stage, SceneVariant variant);
