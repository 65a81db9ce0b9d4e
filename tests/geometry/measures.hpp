// SPDX-License-Identifier: MIT
// Areas and volumes of meshes.
#pragma once

#include <glm/geometric.hpp>

#include "geometry/mesh.hpp"

inline double area(const nicol::Mesh& mesh) {
    double sum = 0.0;
    for (const glm::uvec3& t : mesh.triangles)
        sum += 0.5 * glm::length(glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                            mesh.positions[t.z] - mesh.positions[t.x]));
    return sum;
}

/// Returns the signed volume inside a closed mesh, positive if its front faces outwards.
inline double volume(const nicol::Mesh& mesh) {
    double sum = 0.0;
    for (const glm::uvec3& t : mesh.triangles)
        sum += glm::dot(mesh.positions[t.x], glm::cross(mesh.positions[t.y], mesh.positions[t.z])) / 6.0;
    return sum;
}
