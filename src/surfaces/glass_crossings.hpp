// SPDX-License-Identifier: MIT
// Crossings of rays with a scene's glass, for shadow rays and for the bake.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "shading/glass_shadows.hpp"
#include "surfaces/geometry.hpp"
#include "visibility/bake_rays.hpp"

namespace nicol {

/// First hit of a ray; RayHit::triangle is an index into the geometry's triangles.
using FirstHit = std::function<std::optional<RayHit>(const Ray& ray)>;

/// Glass that light passes.
enum class PassedGlass {
    all,
    unbent,  ///< smooth glass that bends light stops it; FocusedLight holds what passes
};

/// Returns what GlassShadows needs to know. The geometry must outlive the result.
[[nodiscard]] GlassShadows::FirstCrossing first_crossing(const WorldGeometry& geometry, FirstHit intersect,
                                                         PassedGlass passed);

/// Returns the glass that the environment's light passes, of instances that cast shadows; null: none. The
/// result keeps the geometry. Throws what RayScene throws.
[[nodiscard]] std::shared_ptr<const BakeGlass> glass_of(const std::shared_ptr<const WorldGeometry>& geometry);

}  // namespace nicol
