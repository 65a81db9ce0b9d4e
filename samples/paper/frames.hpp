// SPDX-License-Identifier: MIT
// What a step takes by the dense and by the factored method: a row of table 4.
#pragma once

#include <cstdint>

#include "steps.hpp"

struct MethodCost {
    double bytes = 0;              ///< kept a vertex: light, shadows, matrices, visibility, geometry
    double light_ms = 0;           ///< median frame in which the light rotates
    double camera_ms = 0;          ///< median frame in which the camera moves
    double light_physical_ms = 0;  ///< light_ms with Eq. 70
};

struct Cost {
    std::uint64_t vertices = 0;
    MethodCost dense, factored;
};

/// The scenes keep their work from step to step. The methods, with and without Eq. 70, alternate; every
/// frame differs from the one before, and drawing it is waited for.
Cost measure(const Stage& stage, nicol_scene dense, nicol_scene factored, const Recipe& recipe,
             std::uint32_t frames, nicol_framebuffer target);
