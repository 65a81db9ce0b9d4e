// SPDX-License-Identifier: MIT
#include "scene/rotation.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "arguments.hpp"

namespace nicol {

glm::dmat3 rotation_of(const glm::dmat4& to_world, const char* what) {
    glm::dmat3 axes(to_world);
    for (int i = 0; i < 3; ++i) {
        const double length = glm::length(axes[i]);
        if (!(length > 0) || !std::isfinite(length)) {
            refuse(std::string(what) + ": to_world has an axis without length or that is not finite");
        }
        axes[i] /= length;
    }
    for (int i = 0; i < 3; ++i) {
        if (std::abs(glm::dot(axes[i], axes[(i + 1) % 3])) > 1e-5 || glm::determinant(axes) < 0) {
            refuse(std::string(what) + ": to_world must rotate without shearing or mirroring");
        }
    }
    return axes;
}

}  // namespace nicol
