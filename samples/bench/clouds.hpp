// SPDX-License-Identifier: MIT
// Made-up photographs of the sky.
#pragma once

#include "common/handles.hpp"

/// Returns a photograph of clouds in three channels, of the size of the forest's. Another number is another
/// photograph.
Environment clouds(nicol_context context, int number);
