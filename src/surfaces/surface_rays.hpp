// SPDX-License-Identifier: MIT
// Ray hierarchy of a scene's surfaces, shared by bake, refinement and local lights.
#pragma once

#include <cstdint>
#include <memory>

#include "geometry/ray_scene.hpp"
#include "surfaces/scene_geometry.hpp"
#include "versioned.hpp"

namespace nicol {

/// Builds the hierarchy once per version of the geometry, when it is first asked for. A refinement divides
/// triangles and moves none, so the hierarchy of the surfaces as given serves it too.
class SurfaceRays {
public:
    /// Returns the hierarchy of the surfaces' triangles, in their axes. Throws what RayScene throws.
    [[nodiscard]] std::shared_ptr<const RayScene> of(const SceneGeometry& surfaces);
    /// Gives the memory back once the last user of the hierarchy lets go.
    void clear() noexcept;

private:
    std::shared_ptr<const WorldGeometry> geometry_;  // presence_of() refers to it
    Stage<Version> building_;
    std::shared_ptr<const RayScene> rays_;
};

}  // namespace nicol
