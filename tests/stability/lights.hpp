// SPDX-License-Identifier: MIT
// Named lights for the stability tests.
#pragma once

#include <map>
#include <string>

#include "light/environment.hpp"
#include "material/brute_force.hpp"

namespace nicol::test {

using Lights = std::map<std::string, PshVector>;

/// Returns an image of `background` with one pixel of value `pixel`.
inline EnvironmentPtr hot_pixel(const Stokes& background, const Stokes& pixel) {
    EquirectImage image(64, 33, 3);
    for (std::size_t i = 0; i < image.data.size(); ++i)
        image.data[i] = static_cast<float>(background[static_cast<int>(i % 4)]);
    for (int c = 0; c < 3; ++c)
        for (std::size_t p = 0; p < 4; ++p)
            image.at(c, 9, 23)[p] = static_cast<float>(pixel[static_cast<int>(p)]);
    return image_environment(image);
}

inline PshVector times(PshVector light, double factor) {
    for (double& coefficient : light.data()) coefficient *= factor;
    return light;
}

inline Lights usual_lights(int order) {
    return {{"random light", random_light(order, 3, 4, 1)},
            {"a clear sky", rayleigh_sky({.sun_direction = {0.4, 0.5, 0.3}, .turbidity = 3})->project(order)},
            {"even light", constant_environment({1, 0.5, 0.25})->project(order)}};
}

inline Lights stress_lights(int order) {
    const PshVector random = random_light(order, 3, 4, 2);
    return {
        {"light of 1e-6", times(random, 1e-6)},
        {"light of 1e6", times(random, 1e6)},
        {"a pixel of 1e7", hot_pixel({1, 0, 0, 0}, {1e7, 0, 0, 0})->project(order)},
        {"a polarized pixel of 1e7 in darkness", hot_pixel({0, 0, 0, 0}, {1e7, 0, 1e7, 0})->project(order)},
        {"fully polarized light", hot_pixel({1, 1, 0, 0}, {1, 1, 0, 0})->project(order)},
        {"circular light", hot_pixel({1, 0, 0, 1}, {1, 0, 0, -1})->project(order)},
        {"nearly black, fully polarized light",
         hot_pixel({1e-6, 0, -1e-6, 0}, {1e-6, 0, -1e-6, 0})->project(order)}};
}

}  // namespace nicol::test
