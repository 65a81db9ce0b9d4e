// SPDX-License-Identifier: MIT
// A scene's surfaces under other light and of other material.
#pragma once

#include "stage.hpp"

enum class Costume {
    own,    ///< as the scene has it
    full,   ///< polarized sky on rough plastic: no Stokes component can be left out
    plain,  ///< the same sky, unpolarized, on diffuse surfaces of the same colour
};

void dress(Stage& stage, Costume costume);
