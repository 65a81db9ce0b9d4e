// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace nicol {

[[nodiscard]] inline bool is_finite(const glm::vec2& v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}
[[nodiscard]] inline bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
[[nodiscard]] inline bool is_finite(const glm::vec4& v) {
    return is_finite(glm::vec3(v)) && std::isfinite(v.w);
}

}  // namespace nicol
