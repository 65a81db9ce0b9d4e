// SPDX-License-Identifier: MIT
// Render options of a benchmark image.
#pragma once

#include <nicol.h>

#include <cstdint>
#include <string>

enum class High { none, convolution, split };

struct Recipe {
    bool defaults = false;  ///< the library's defaults, except for shadows and the place of shading
    nicol_method method = NICOL_METHOD_FACTORED;
    int low = 4;
    High high = High::none;
    int top = 9;  ///< highest order; no effect without high orders
    bool shadows = true;
    std::uint32_t directions = 2048;  ///< number of the bake's directions
    double tolerance = 0;             ///< above 0: chooses the orders
    nicol_shade_at shade_at = NICOL_SHADE_AT_VERTICES;
    std::uint32_t samples = 1;  ///< number per pixel
    nicol_components components = NICOL_COMPONENTS_ALL;
    int split = 0;  ///< most extracted lights, which become local lights; no effect with `defaults`

    /// Returns a name like "dense 4 + convolution to 9, at pixels, no shadows".
    [[nodiscard]] std::string name() const;
    [[nodiscard]] nicol_render_options options() const;
};

/// Returns the recipe of the library's defaults with 8 samples a pixel.
inline Recipe default_recipe() {
    return {.defaults = true, .shade_at = NICOL_SHADE_AT_AUTOMATIC, .samples = 8};
}

/// Returns options of the reference method.
nicol_render_options reference_options(std::uint32_t samples, std::uint64_t seed, bool shadows);
