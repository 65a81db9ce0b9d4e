// SPDX-License-Identifier: MIT
// Weights of the layers of a material.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "simd/lanes.hpp"

namespace nicol {

/// Weights of one layer at sixteen points.
struct LayerWeights {
    std::array<Lanes, 3> value;  ///< weights of red, green and blue; only red is used if all are equal
    std::uint32_t points;        ///< bit i: a weight of point i is not 0; if no bit is set, value is unset
    bool equal;                  ///< red, green and blue have equal weights
    /// Returns the weights of an image's channel. They are equal unless the image has three channels, which
    /// several lights side by side may repeat.
    [[nodiscard]] const Lanes& of(std::size_t channel) const { return value[equal ? 0 : channel % 3]; }
};

}  // namespace nicol
