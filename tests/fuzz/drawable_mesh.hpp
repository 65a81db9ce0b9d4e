// SPDX-License-Identifier: MIT
// Properties of every mesh that a reader returns.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/mesh.hpp"
#include "memory_file.hpp"

namespace nicol::fuzz {

inline void require_drawable(const Mesh& mesh) {
    require(mesh.normals.size() == mesh.positions.size(), "a normal for each vertex");
    for (const glm::vec3& n : mesh.normals)
        require(std::abs(glm::length(n) - 1.0F) < 1e-3F, "normals have length 1");
    for (const glm::uvec3& t : mesh.triangles)
        for (glm::length_t i = 0; i < 3; ++i)
            require(t[i] < mesh.positions.size(), "triangles use vertices that exist");
}

}  // namespace nicol::fuzz
