// SPDX-License-Identifier: MIT
// The rows of figure 20, and what each adds to the light.
#pragma once

#include <span>

#include "stage.hpp"

struct Step {
    const char* name;  ///< of its row in images, in the letters of font.hpp
    const char* file;  ///< of its Stokes image
    Recipe recipe;
};

/// The three of the paper by its own method, then the library's default, which is the factored method.
std::span<const Step> steps();
