// SPDX-License-Identifier: MIT
// Render options of a benchmark image.
#pragma once

#include <nicol.h>

#include <cstdint>
#include <string>

enum class High { none, convolution, split };

struct Recipe {
    bool defaults = false;  ///< the library's, but for shadows and where it shades
    nicol_method method = NICOL_METHOD_FACTORED;
    int low = 4;
    High high = High::none;
    int top = 9;  ///< highest order; without effect where high is none
    bool shadows = true;
    std::uint32_t directions = 2048;  ///< of the bake
    double tolerance = 0;             ///< above 0: chooses the orders
    nicol_shade_at shade_at = NICOL_SHADE_AT_VERTICES;
    std::uint32_t samples = 1;  ///< of a pixel
    int split = 0;  ///< lamps of the light that become local lights, at most; without effect by default

    /// As in "dense 4 + convolution to 9, at pixels, no shadows".
    [[nodiscard]] std::string name() const;
    [[nodiscard]] nicol_render_options options() const;
};

/// Of the reference method.
nicol_render_options reference_options(std::uint32_t samples, std::uint64_t seed, bool shadows);
