// SPDX-License-Identifier: MIT
// Surfaces that rays of a bake meet: those that block light, and glass that dims it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "geometry/ray_scene.hpp"

namespace nicol {

/// Glass that the environment's light passes on its way to vertices. Visibility has one bit for a direction,
/// so that glass of transmittance T stops a share 1 - T of the rays: those of directions that are spread
/// evenly, the same at all vertices.
struct BakeGlass {
    std::shared_ptr<const RayScene> surfaces;  ///< the glass alone
    /// Returns the transmittance of all glass on a ray, 0 to 1, for unpolarized light. Threads call it at
    /// once.
    std::function<double(const Ray& ray)> transmittance;
    std::vector<glm::uvec3> triangles;  ///< triangles of the glass, as indices into the bake's positions
    std::string key;                    ///< everything that the transmittance depends on but the triangles
};

struct BakeRays {
    std::shared_ptr<const RayScene> blockers;
    std::shared_ptr<const BakeGlass> glass;  ///< null: none

    using Numbers = std::array<std::size_t, RayBundle::kRays>;
    /// Returns which rays of a bundle, of those in `active`, do not reach the environment. numbers: of the
    /// rays' directions.
    [[nodiscard]] std::uint16_t occluded(const glm::vec3& origin, const RayBundle& bundle,
                                         const Numbers& numbers, std::uint16_t active) const;
};

}  // namespace nicol
