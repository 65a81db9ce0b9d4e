// SPDX-License-Identifier: MIT
// Ray hierarchy of the surfaces as drawn.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "geometry/ray_scene.hpp"
#include "surfaces/refined_surfaces.hpp"

namespace nicol {

/// Visible triangles of a geometry, the added ones of a refinement included. Rays pass the backs of two-sided
/// surfaces because their other side has triangles of its own. Immutable.
class DrawnTriangles {
public:
    enum class Masks {
        pass,   ///< rays pass where an alpha mask says that there is no surface
        block,  ///< masked triangles are whole
    };

    /// The geometry must outlive the object. Throws what RayScene throws.
    DrawnTriangles(const WorldGeometry& geometry, Masks masks);

    /// Returns the first hit of a ray. RayHit::triangle is an index into the geometry's triangles.
    [[nodiscard]] std::optional<RayHit> intersect(const Ray& ray) const;

    /// Sets hits[i] to the first hit of rays[i], of which many are traced faster than one by one.
    void intersect(std::span<const Ray> rays, std::span<std::optional<RayHit>> hits) const;

    /// Finds the first hits of a packet. HitPacket::triangle is that of the geometry, as of single rays.
    [[nodiscard]] std::uint16_t intersect(const RayPacket& packet, std::uint16_t active,
                                          HitPacket& hits) const;

    [[nodiscard]] const std::shared_ptr<const RayScene>& scene() const noexcept { return scene_; }

private:
    std::uint32_t one_sided_;  // number of one-sided triangles
    std::shared_ptr<const RayScene> scene_;
};

/// Hierarchy that its users share. It exists as long as one of them keeps it.
class DrawnRays {
public:
    /// Returns the hierarchy of the surfaces as they are, whose masks let rays pass. The surfaces must stay
    /// as they are while the hierarchy is used. Throws what RayScene throws.
    [[nodiscard]] std::shared_ptr<const DrawnTriangles> get(const RefinedSurfaces& surfaces);

private:
    Version version_ = 0;  // version of the surfaces of shared_
    std::weak_ptr<const DrawnTriangles> shared_;
};

}  // namespace nicol
