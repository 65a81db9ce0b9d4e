// SPDX-License-Identifier: MIT
// Rays of light that travels from local lights over smooth surfaces to others.
#pragma once

#include <memory>
#include <optional>

#include "geometry/ray_scene.hpp"
#include "surfaces/geometry.hpp"
#include "surfaces/smooth_surfaces.hpp"

namespace nicol {

/// Surfaces that light meets, with the roles of their instances.
class PhotonRays {
public:
    /// Keeps references to both arguments.
    PhotonRays(const WorldGeometry& geometry, const SmoothSurfaces& smooth);

    /// Returns whether the surface of a range hides light from others: whether it casts shadows, and is not
    /// glass that the camera does not see.
    [[nodiscard]] static bool blocks(const VertexRange& range);

    /// Returns whether a surface that blocks light lies on a ray, as RayScene::occluded() does.
    [[nodiscard]] bool occluded(const Ray& ray) const;
    /// Returns the first surface on a ray that blocks light or that the camera sees. RayHit::triangle is an
    /// index into the geometry's triangles.
    [[nodiscard]] std::optional<RayHit> first(const Ray& ray) const;
    /// Returns the value of Ray::nearest that leaves out a hit surface.
    [[nodiscard]] double beyond(const RayHit& hit) const;

private:
    const WorldGeometry& geometry_;
    const SmoothSurfaces& smooth_;
    bool some_pass_light_;                    // whether the camera sees surfaces that block no light
    std::unique_ptr<const RayScene> unseen_;  // surfaces that block light unseen; null: none
};

}  // namespace nicol
