// SPDX-License-Identifier: MIT
// A mesh of any size that shadows itself.
#pragma once

#include "common/handles.hpp"

/// About `vertices` of them, on a sphere of radius 1 with waves of a tenth.
Mesh make_bumpy_sphere(nicol_context context, std::uint32_t vertices);
