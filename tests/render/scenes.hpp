// SPDX-License-Identifier: MIT
// Parts of small scenes: a mesh that is quickly baked, light of all orders, cameras.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <utility>

#include "geometry/mesh.hpp"
#include "harmonics/light_layout.hpp"
#include "light/environment.hpp"
#include "scene/projection.hpp"

namespace nicol::test {

/// A sphere of few vertices: a cube's, moved out to unit length. cells: along an edge of the cube.
inline std::shared_ptr<const Mesh> coarse_sphere(int cells) {
    Mesh mesh = make_cube(cells);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        mesh.normals[i] = mesh.positions[i] = glm::normalize(mesh.positions[i]);
    }
    return std::make_shared<const Mesh>(std::move(mesh));
}

/// Light of all orders up to the last, falling as that of images does.
inline EnvironmentPtr falling_light(int order, LightKind kind, int channels = 3) {
    PshVector light(order, channels);
    for (int c = 0; c < channels; ++c) {
        light.at(c, 0, 0, 0) = 6 + c;
        for (int l = 0; l <= order; ++l) {
            for (int m = -l; m <= l; ++m) {
                for (int p = l == 0 ? 3 : 0; p < static_cast<int>(kind); ++p) {
                    if (l < 2 && (p == 1 || p == 2)) continue;
                    light.at(c, l, m, p) = std::sin(7.1 * l + 3.3 * m + 5 * p + 0.2 * c) / (l + 1);
                }
            }
        }
    }
    return psh_environment(light);
}
inline EnvironmentPtr falling_light(int order, bool polarized, int channels = 3) {
    return falling_light(order, polarized ? LightKind::full : LightKind::unpolarized, channels);
}

inline Camera camera_at(const glm::dvec3& eye, const glm::dvec3& target = glm::dvec3(0)) {
    Camera camera;
    camera.to_world = look_at(eye, target, {0, 1, 0});
    return camera;
}

}  // namespace nicol::test
