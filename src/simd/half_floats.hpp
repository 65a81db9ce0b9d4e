// SPDX-License-Identifier: MIT
// Conversion to half precision.
#pragma once

#include <cstdint>
#include <span>

namespace nicol {

/// Stores the bits of the nearest IEEE 754 half of each float, ties to even, infinite from 65520 on.
/// NaN stays NaN. The spans have the same length.
void to_half(std::span<const float> from, std::span<std::uint16_t> to);

}  // namespace nicol
