// SPDX-License-Identifier: MIT
// Ray hierarchy of a scene's surfaces, shared by bake, refinement and local lights.
#pragma once

#include <cstdint>
#include <memory>

#include "geometry/ray_scene.hpp"
#include "surfaces/scene_geometry.hpp"
#include "versioned.hpp"

namespace nicol {

/// Ray hierarchy, built once per version of the geometry, when it is first requested. A refinement divides
/// triangles and moves none, so the hierarchy of the unrefined surfaces also serves their refinement.
class SurfaceRays {
public:
    /// Returns the hierarchy of the surfaces' triangles, in the surfaces' axes. Throws the errors of
    /// RayScene.
    [[nodiscard]] std::shared_ptr<const RayScene> of(const SceneGeometry& surfaces);
    /// Releases the hierarchy. Its memory is freed once the last user releases it, too.
    void clear() noexcept;

private:
    std::shared_ptr<const WorldGeometry> geometry_;  // presence_of() refers to it
    Stage<Version> building_;
    std::shared_ptr<const RayScene> rays_;
};

}  // namespace nicol
