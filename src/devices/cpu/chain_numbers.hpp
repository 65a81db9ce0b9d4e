// SPDX-License-Identifier: MIT
// Numbers of chains: matrices in the form that chains multiply, and choices by seeds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>

#include "polarization/mueller.hpp"

namespace nicol {

/// Returns a seed as a number of [0, 1).
[[nodiscard]] inline double fraction(std::uint32_t bits) {
    return bits * 0x1p-32;
}

/// Returns a matrix by columns, as glm multiplies.
[[nodiscard]] inline glm::mat4 in_columns(const Mueller& m) {
    glm::mat4 out;
    for (glm::length_t row = 0; row < 4; ++row)
        for (glm::length_t column = 0; column < 4; ++column)
            out[column][row] =
                static_cast<float>(m(static_cast<std::size_t>(row), static_cast<std::size_t>(column)));
    return out;
}

}  // namespace nicol
