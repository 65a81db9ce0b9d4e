// SPDX-License-Identifier: MIT
// Hierarchy of shadow rays of a scene's surfaces, shared by bake, refinement and local lights.
#pragma once

#include <memory>

#include "geometry/ray_scene.hpp"
#include "surfaces/scene_geometry.hpp"

namespace nicol {

/// Builds the hierarchy of the surfaces' triangles, in their axes, when it is first asked for. A refinement
/// divides triangles and moves none, so the hierarchy of the surfaces as given serves it too. The object
/// belongs to one render; its users keep the hierarchy as long as they need it.
class SurfaceRays {
public:
    /// The surfaces must outlive the object and stay unchanged.
    explicit SurfaceRays(const SceneGeometry& surfaces) : surfaces_(surfaces) {}

    /// Returns the hierarchy, which keeps its geometry alive. Throws what RayScene throws.
    [[nodiscard]] std::shared_ptr<const RayScene> get();
    /// Gives the memory back unless a user keeps the hierarchy.
    void release() noexcept { rays_.reset(); }

private:
    const SceneGeometry& surfaces_;
    std::shared_ptr<const RayScene> rays_;
};

}  // namespace nicol
