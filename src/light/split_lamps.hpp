// SPDX-License-Identifier: MIT
// An environment as lamps and what is left of it.
#pragma once

#include <memory>
#include <vector>

#include "light/environment.hpp"
#include "light/lamp.hpp"

namespace nicol {

struct SplitLight {
    EnvironmentPtr rest;
    std::vector<std::shared_ptr<const Lamp>> lamps;  ///< those of which harmonics would miss most first
};

/// Takes at most `most` lamps (0 and up) out of an image: parts within 0.5 rad and 0.2 sr that are brighter
/// than four times the mean, unless all that orders 10 to 32 have of them is little. rest + lamps is the
/// light that was, up to rounding. Light that is no image has no lamps, null has none; without lamps the rest
/// is `light` itself.
[[nodiscard]] SplitLight split_lamps(const EnvironmentPtr& light, int most);

}  // namespace nicol
