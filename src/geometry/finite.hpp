// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace nicol {

[[nodiscard]] inline bool is_finite(const glm::vec2& v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}
[[nodiscard]] inline bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace nicol
