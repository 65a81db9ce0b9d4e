// SPDX-License-Identifier: MIT
// The rows of figure 20.
#pragma once

#include <span>

#include "stage.hpp"

struct Step {
    const char* name;  ///< name of the row in images, in letters of font.hpp
    const char* file;  ///< name of the Stokes image's file
    Recipe recipe;
};

/// Returns the three steps of the paper by its method, then the library's default, the factored method.
std::span<const Step> steps();
