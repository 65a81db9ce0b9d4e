// SPDX-License-Identifier: MIT
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace nicol {

/// Returns a vector scaled to length 1, by way of double precision: squares of floats may vanish or overflow.
[[nodiscard]] inline glm::vec3 unit(const glm::vec3& v) {
    return {glm::normalize(glm::dvec3(v))};
}

}  // namespace nicol
