// SPDX-License-Identifier: MIT
// An environment as extracted lights and what is left of it.
#pragma once

#include <memory>
#include <vector>

#include "light/environment.hpp"
#include "light/extracted_light.hpp"

namespace nicol {

struct SplitLight {
    EnvironmentPtr rest;
    std::vector<std::shared_ptr<const ExtractedLight>>
        extracted_lights;  ///< those of which harmonics would miss most first
};

/// Takes at most `most` extracted lights (0 and up) out of an image: parts within 0.5 rad and 0.2 sr that are
/// brighter than four times the mean, unless all that orders 10 to 32 have of them is little. rest +
/// extracted lights is the light that was, up to rounding. Light that is no image has no extracted lights,
/// null has none; without extracted lights the rest is `light` itself.
[[nodiscard]] SplitLight extract_lights(const EnvironmentPtr& light, int most);

}  // namespace nicol
