// SPDX-License-Identifier: MIT
// Numbers of sixteen vertices side by side, for vector instructions.
#pragma once

#include <array>
#include <cstddef>

namespace nicol {

inline constexpr std::size_t kLanes = 16;

/// Single-precision numbers of sixteen vertices.
struct alignas(64) Lanes {
    std::array<float, kLanes> value;

    [[nodiscard]] float& operator[](std::size_t i) { return value[i]; }
    [[nodiscard]] float operator[](std::size_t i) const { return value[i]; }
};

}  // namespace nicol
