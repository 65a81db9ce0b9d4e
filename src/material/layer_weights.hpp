// SPDX-License-Identifier: MIT
// How much of each layer of a material there is.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "simd/lanes.hpp"

namespace nicol {

/// The weights of one layer at sixteen points.
struct LayerWeights {
    std::array<Lanes, 3> value;  ///< of red, green and blue; where they are equal, of red alone
    std::uint32_t points;        ///< bit i: a weight of point i is not 0; without any there are no values
    bool equal;                  ///< those of the three channels are
    /// Of a channel of an image; where there are not three, the weights of red, green and blue are equal.
    [[nodiscard]] const Lanes& of(std::size_t channel) const {
        return value[equal ? 0 : channel < 3 ? channel : 2];
    }
};

}  // namespace nicol
