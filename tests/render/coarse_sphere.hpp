// SPDX-License-Identifier: MIT
// A mesh that is quickly baked.
#pragma once

#include <glm/geometric.hpp>
#include <memory>
#include <utility>

#include "geometry/mesh.hpp"

namespace nicol::test {

/// A sphere of few vertices: a cube's, moved out to unit length. cells: along an edge of the cube.
inline std::shared_ptr<const Mesh> coarse_sphere(int cells) {
    Mesh mesh = make_cube(cells);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        mesh.normals[i] = mesh.positions[i] = glm::normalize(mesh.positions[i]);
    }
    return std::make_shared<const Mesh>(std::move(mesh));
}

}  // namespace nicol::test
