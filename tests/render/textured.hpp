// SPDX-License-Identifier: MIT
// Textures of surfaces, and meshes with texture coordinates.
#pragma once

#include <utility>

#include "function_texture.hpp"
#include "geometry/mesh.hpp"
#include "material/mixture.hpp"
#include "test.hpp"

namespace nicol::test {

/// Returns a normal map that leaves normals unchanged but does not count as constant.
inline TexturePtr flat_normals() {
    return texture_of([](const TexturePoint&) { return glm::vec4(0.5F, 0.5F, 1, 1); });
}
inline TexturePtr mesh_colors(ColorsOf of) {
    return std::make_shared<const FunctionTexture>(
        [](const TexturePoint& point) { return glm::vec4(point.color, 1); }, 3, glm::vec2(0, 1), of);
}

/// Returns the mesh with texture coordinates linear in x and y: 0 to 1 over a rectangle or cube, v downwards.
/// Every triangle has separate ones.
inline std::shared_ptr<const Mesh> with_texcoords(const Mesh& mesh) {
    Mesh out = mesh;
    out.texcoords.clear();
    out.texcoord_triangles.clear();
    for (const glm::uvec3& t : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(out.texcoords.size());
        for (const glm::length_t k : {2, 0, 1}) {
            const glm::vec3& p = mesh.positions[t[k]];
            out.texcoords.emplace_back(0.5F + 0.5F * p.x, 0.5F - 0.5F * p.y);
        }
        out.texcoord_triangles.emplace_back(first + 1, first + 2, first);
    }
    return std::make_shared<const Mesh>(std::move(out));
}

}  // namespace nicol::test
