// SPDX-License-Identifier: MIT
// The cost of a step by the dense and by the factored method: a row of table 4.
#pragma once

#include <cstdint>

#include "steps.hpp"

struct MethodCost {
    double bytes = 0;              ///< bytes per vertex: light, shadows, matrices, visibility, geometry
    double light_ms = 0;           ///< median frame with a rotated light
    double camera_ms = 0;          ///< median frame with a moved camera
    double light_physical_ms = 0;  ///< light_ms with Eq. 70
};

struct Cost {
    std::uint64_t vertices = 0;
    MethodCost dense, factored;
};

/// Measures frames of both methods, with and without Eq. 70, in alternation. Every frame differs from the
/// frame before, and its drawing is waited for. The scenes reuse their work in later steps.
Cost measure(const Stage& stage, nicol_scene dense, nicol_scene factored, const Recipe& recipe,
             std::uint32_t frames, nicol_framebuffer target);
