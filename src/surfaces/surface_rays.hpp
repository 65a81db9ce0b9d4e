// SPDX-License-Identifier: MIT
// Hierarchy of shadow rays of a scene's surfaces, shared by bake, refinement and local lights.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <tuple>

#include "geometry/ray_scene.hpp"
#include "surfaces/scene_geometry.hpp"
#include "visibility/bake_rays.hpp"

namespace nicol {

/// The hierarchy of the triangles that block light, in the surfaces' axes. A refinement divides triangles and
/// moves none, so the hierarchy of the surfaces as given serves it too. Users keep the hierarchy as long as
/// they need it.
///
/// The hierarchy is flat as long as all instances were placed together. After a change it consists of parts,
/// and a further change builds only the parts that it touches. Hits are the same in both forms, with one
/// exception: if two triangles lie in one place, either may be hit.
class SurfaceRays {
public:
    /// The surfaces must outlive the object.
    explicit SurfaceRays(const SceneGeometry& surfaces) : surfaces_(surfaces) {}

    /// Returns the hierarchy of the surfaces as they are. RayHit::triangle is an index into the geometry's
    /// triangles. Throws what RayScene throws.
    [[nodiscard]] std::shared_ptr<const RayScene> get();
    /// Returns the glass that the environment's light passes, of the surfaces as they are; null: none. Throws
    /// what RayScene throws.
    [[nodiscard]] std::shared_ptr<const BakeGlass> glass();
    /// Gives back the memory that a further change does not need, unless a user keeps the hierarchy.
    void release() noexcept {
        released_ = rays_;
        rays_.reset();
    }

private:
    // Version in which the blockers were placed, their batch, and the number of their triangles, because
    // blockers may have left the batch.
    using PartKey = std::tuple<Version, std::uint32_t, std::size_t>;

    const SceneGeometry& surfaces_;
    Version version_ = 0;  // of the surfaces of rays_
    std::shared_ptr<const RayScene> rays_;
    std::weak_ptr<const RayScene> released_;
    std::map<PartKey, std::shared_ptr<const RayScene>> parts_;
    Version glass_version_ = 0;  // of the surfaces of glass_
    std::shared_ptr<const BakeGlass> glass_;
};

}  // namespace nicol
