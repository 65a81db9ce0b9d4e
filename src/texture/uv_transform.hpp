// SPDX-License-Identifier: MIT
// Transform from a surface's texture coordinates to a texture's.
#pragma once

#include <cmath>
#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include "arguments.hpp"

namespace nicol {

/// Affine map: linear * uv + offset.
struct UvTransform {
    /// Takes the map from a matrix for (u, v, 1). Throws Error(invalid_argument) unless the matrix is finite
    /// with last row 0 0 1.
    explicit UvTransform(const glm::dmat3& to_uv) : linear(to_uv), offset(to_uv[2]) {
        for (glm::length_t column = 0; column < 3; ++column) {
            for (glm::length_t row = 0; row < 3; ++row)
                require(std::isfinite(static_cast<float>(to_uv[column][row])),
                        "to_uv has an element that is not finite");
            require(to_uv[column][2] == (column == 2 ? 1.0 : 0.0), "the last row of to_uv must be 0 0 1");
        }
    }

    [[nodiscard]] glm::vec2 operator()(const glm::vec2& uv) const { return linear * uv + offset; }

    [[nodiscard]] glm::dmat3 matrix() const {
        return {glm::dvec3(linear[0], 0), glm::dvec3(linear[1], 0), glm::dvec3(offset, 1)};
    }

    glm::mat2 linear;
    glm::vec2 offset;
};

/// Returns the largest integer that is not above x, which must lie within +-2^30. The function takes three
/// instructions, whereas std::floor is a call.
[[nodiscard]] inline int floor_to_int(float x) {
    const int towards_zero = static_cast<int>(x);
    return towards_zero - static_cast<int>(x < static_cast<float>(towards_zero));
}

/// Limits coordinates to the range that floor_to_int() accepts. Not-a-number becomes the lower end.
[[nodiscard]] inline float within_int(float x) {
    constexpr float most = 1 << 30;
    const float above = x > -most ? x : -most;
    return above < most ? above : most;
}

}  // namespace nicol
