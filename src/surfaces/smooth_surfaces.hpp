// SPDX-License-Identifier: MIT
// Smooth surfaces of a scene, whose pixels show what rays meet, and the rays.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "geometry/ray_scene.hpp"
#include "shading/glass_shadows.hpp"
#include "surfaces/convex_bodies.hpp"
#include "surfaces/drawn_rays.hpp"
#include "surfaces/refined_surfaces.hpp"
#include "versioned.hpp"

namespace nicol {

/// Way in which rays go on at a surface.
enum class Smoothness : std::uint8_t {
    none,            ///< nothing that rays follow
    mirror,          ///< a smooth term of the material mirrors other surfaces
    lobes,           ///< narrow lobes of the material reflect other surfaces, and smooth terms if any
    boundary,        ///< light is reflected and transmitted, see Material::smooth_boundary()
    rough_boundary,  ///< light is transmitted by facets; the material's terms are what the front reflects
};

/// Returns how light goes on from surfaces of a material. lobes: whether rays follow lobes.
[[nodiscard]] Smoothness smoothness_of(const Material& material, bool lobes);

class SmoothSurfaces {
public:
    /// Takes over changes of the surfaces as drawn, which must outlive this object. Takes their hierarchy
    /// from `rays` only if there are smooth surfaces. lobes: whether rays follow lobes, see follows_lobes().
    void update(const RefinedSurfaces& surfaces, DrawnRays& rays, bool lobes);

    [[nodiscard]] bool any() const noexcept { return !of_triangles_.empty(); }
    /// Returns whether rays show what some terms of materials reflect of other surfaces.
    [[nodiscard]] bool mirrors() const noexcept { return mirrors_; }
    /// Returns the smoothness of a triangle of the geometry. any() must be true.
    [[nodiscard]] Smoothness of(std::uint32_t triangle) const { return of_triangles_[triangle]; }

    /// Returns whether rays that leave the front of a triangle meet nothing; false for triangles that are not
    /// smooth. any() must be true.
    [[nodiscard]] bool open(std::uint32_t triangle) const { return open_[triangle] != 0; }

    /// Returns the convex bodies of smooth glass.
    [[nodiscard]] const ConvexBodies& convex() const noexcept { return convex_; }

    /// Returns whether rays may begin at a triangle that an image shows: not at open mirrors, which reflect
    /// lights alone. any() must be true.
    [[nodiscard]] bool followed(std::uint32_t triangle) const {
        return of(triangle) != Smoothness::none && !(of(triangle) == Smoothness::mirror && open(triangle));
    }

    /// Sets hits[i] to the first hit of rays[i], which pass the backs of two-sided surfaces because their
    /// other side has triangles of its own. RayHit::triangle is an index into the geometry's triangles. any()
    /// must be true.
    void intersect(std::span<const Ray> rays, std::span<std::optional<RayHit>> hits) const {
        rays_->intersect(rays, hits);
    }

    /// Finds the first hits of a packet. HitPacket::triangle is that of the geometry, as of single rays.
    [[nodiscard]] std::uint16_t intersect(const RayPacket& packet, std::uint16_t active,
                                          HitPacket& hits) const {
        return rays_->intersect(packet, active, hits);
    }

    /// Returns the ray hierarchy if light passes some surfaces, which mirrors then show; else null.
    [[nodiscard]] std::shared_ptr<const RayScene> before_mirrors() const;

    /// Returns the first hit of a ray, as intersect() of several does.
    [[nodiscard]] std::optional<RayHit> intersect(const Ray& ray) const { return rays_->intersect(ray); }
    /// Returns RayScene::occluded(). any() must be true.
    [[nodiscard]] bool occluded(const Ray& ray) const { return rays_->scene()->occluded(ray); }

    /// Returns the glass that light passes on its way to other surfaces; null: none. Holds until the surfaces
    /// change.
    [[nodiscard]] const std::shared_ptr<const GlassShadows>& glass() const noexcept { return glass_; }
    /// Returns the glass for shadow rays of local lights, which smooth glass that bends light stops. Null as
    /// glass().
    [[nodiscard]] const std::shared_ptr<const GlassShadows>& unbent_glass() const noexcept {
        return unbent_glass_;
    }
    /// Returns a version that changes whenever the surfaces do.
    [[nodiscard]] Version version() const noexcept { return version_; }

    [[nodiscard]] std::uint64_t bytes() const noexcept {
        return of_triangles_.size() + open_.size() + convex_.bytes();
    }

private:
    Stage<Version, Version, bool> finding_;  // vertices and triangles, materials, whether rays follow lobes
    std::vector<Smoothness> of_triangles_;
    std::vector<std::uint8_t> open_;                            // 1: open triangles
    Stage<Version, std::vector<std::uint8_t>> finding_convex_;  // vertices and triangles, ranges of glass
    ConvexBodies convex_;
    bool mirrors_ = false;          // whether there are triangles of mirrors or lobes
    bool glass_too_ = false;        // whether there are triangles of glass as well
    Stage<Version, bool> tracing_;  // vertices and triangles, whether there are smooth surfaces
    std::shared_ptr<const DrawnTriangles> rays_;
    Stage<Version, Version> shading_;  // vertices and triangles, materials
    std::shared_ptr<const GlassShadows> glass_, unbent_glass_;
    Version version_ = 0;
};

}  // namespace nicol
