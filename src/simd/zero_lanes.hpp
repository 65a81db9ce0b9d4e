// SPDX-License-Identifier: MIT
// Test for numbers that need no computation.
#pragma once

#include <span>

#include "simd/lanes.hpp"

namespace nicol {

/// Returns whether all numbers are 0. Takes no time to speak of where an early one is not.
[[nodiscard]] inline bool all_zero(std::span<const Lanes> numbers) {
    for (const Lanes& lanes : numbers) {
        bool any = false;
        for (const float value : lanes.value) any |= value != 0;
        if (any) return false;
    }
    return true;
}

}  // namespace nicol
