// SPDX-License-Identifier: MIT
// Division of an environment into extracted lights and the rest.
#pragma once

#include <memory>
#include <vector>

#include "light/environment.hpp"
#include "light/extracted_light.hpp"

namespace nicol {

struct SplitLight {
    EnvironmentPtr rest;
    std::vector<std::shared_ptr<const ExtractedLight>>
        extracted_lights;  ///< sorted by the energy that harmonics would miss, largest first
};

/// Takes at most `most` extracted lights (0 and up) out of an image. Extracted lights are parts within 0.5
/// rad and 0.2 sr that are brighter than four times the mean, unless their total in orders 10 to 32 is small.
/// The sum of rest and extracted lights equals `light`, up to rounding. Light that is not an image, or null,
/// has no extracted lights. Without extracted lights the rest is `light` itself.
[[nodiscard]] SplitLight extract_lights(const EnvironmentPtr& light, int most);

}  // namespace nicol
