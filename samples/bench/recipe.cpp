// SPDX-License-Identifier: MIT
#include "recipe.hpp"

std::string Recipe::name() const {
    std::string text = method == NICOL_METHOD_DENSE ? "dense " : "factored ";
    text = defaults ? "by default" : text + std::to_string(low);
    if (!defaults && high != High::none) {
        text += high == High::convolution ? " + convolution to " : " + split to ";
        text += std::to_string(top);
    }
    if (shade_at == NICOL_SHADE_AT_PIXELS) text += ", at pixels";
    if (split != 0) text += ", lights extracted";
    if (samples > 1) text += ", " + std::to_string(samples) + " samples";
    return shadows ? text : text + ", no shadows";
}

nicol_render_options Recipe::options() const {
    nicol_render_options wanted = NICOL_RENDER_OPTIONS_INIT;
    wanted.shade_at = shade_at;
    wanted.pixel_samples = samples;
    wanted.shadows = shadows ? 1 : 0;
    wanted.components = components;
    if (defaults) return wanted;
    wanted.method = method;
    wanted.split_lights = split;
    if (tolerance > 0) {
        wanted.tolerance = tolerance;
    } else {
        wanted.order_low = static_cast<std::uint32_t>(low);
        wanted.order_high = static_cast<std::uint32_t>(high == High::none ? low : top);
    }
    wanted.physical = 0;  // unchanged values, so that no error is hidden
    wanted.refine_tolerance = 0;
    wanted.high_orders = high == High::none          ? NICOL_HIGH_ORDERS_NONE
                         : high == High::convolution ? NICOL_HIGH_ORDERS_CONVOLUTION
                                                     : NICOL_HIGH_ORDERS_SPLIT;
    wanted.bake_directions = directions;
    return wanted;
}

nicol_render_options reference_options(std::uint32_t samples, std::uint64_t seed, bool shadows) {
    nicol_render_options wanted = NICOL_RENDER_OPTIONS_INIT;
    wanted.method = NICOL_METHOD_REFERENCE;
    wanted.samples = samples;
    wanted.seed = seed;
    wanted.shadows = shadows ? 1 : 0;
    return wanted;
}
