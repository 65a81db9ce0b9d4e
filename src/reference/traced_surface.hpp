// SPDX-License-Identifier: MIT
// Surfaces that rays meet: an instance in the world, and a point of the instance.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/ray_scene.hpp"
#include "reference/surface_sampler.hpp"
#include "scene/scene.hpp"

namespace nicol {

/// Material of one side of a surface.
struct TracedMaterial {
    struct Layer {
        const Material* material;
        const SurfaceSampler* sampler;
    };
    const Material* material;
    std::vector<Layer> layers;  ///< layers of a textured material; otherwise the material itself
};

struct TracedSurface {
    Mesh mesh;  ///< mesh in the world
    TracedMaterial front;
    TracedMaterial back;         ///< for a material that is not two-sided: as `front`
    const Emission* emission;    ///< null: the surface emits no light
    glm::dvec3 emission_axis{};  ///< axis of the emission's polarization, in the world
    InstanceRoles roles{};

    /// Returns whether the surface hides lights. Glass that the camera does not see dims nothing.
    [[nodiscard]] bool blocks() const {
        return roles.casts_shadows && (roles.visible || front.material->smooth_boundary() == nullptr);
    }

    /// Returns the alpha mask, or none if the surface has no alpha mask. Valid as long as the surface stays
    /// at its address.
    [[nodiscard]] Presence presence() const;
    /// Returns the position of a hit, from its triangle and weights.
    [[nodiscard]] glm::dvec3 position(const RayHit& hit) const;
    /// Returns the unit normal of the triangle itself, towards its front.
    [[nodiscard]] glm::dvec3 geometric_normal(const RayHit& hit) const;
    /// Returns the distance between the hit triangle and the start of rays that leave it.
    [[nodiscard]] double ray_offset(const RayHit& hit) const;
    /// Returns the unit normal, interpolated between the corners' normals.
    [[nodiscard]] glm::dvec3 normal(const RayHit& hit) const;
    /// Sets `radiance` to the Stokes vectors, in each channel, of the emission at a hit along z of `frame`.
    /// Returns false, and leaves `radiance` as it is, if the surface is not present at the hit or emits no
    /// light in this direction.
    [[nodiscard]] bool emitted(const RayHit& hit, const Frame& frame, std::span<Stokes> radiance) const;
};

/// Point of a surface where light is reflected.
struct SurfaceHit {
    const TracedMaterial& side;  ///< material of the side that the viewer sees
    bool receives_shadows;       ///< InstanceRoles::receives_shadows
    glm::dvec3 position;
    glm::dvec3 geometric_normal;
    double ray_offset;    ///< distance between the surface and the start of rays that leave it
    glm::dvec3 unturned;  ///< interpolated normal, on the side of the shading normal
    bool dimmed;          ///< whether the perturbed normal's light is dimmed by terminator_shadowing()
    /// Frame whose z is the shading normal, on the viewer's side for a two-sided material. For an anisotropic
    /// material, x is the direction of growing texture coordinate u.
    Frame frame;
    glm::dvec3 towards_viewer;  ///< unit vector in `frame`
    TexturePoint point;
};
/// Returns the point of a hit. towards_viewer: unit vector in the world.
[[nodiscard]] SurfaceHit surface_hit(const TracedSurface& surface, const RayHit& hit,
                                     const glm::dvec3& towards_viewer);

}  // namespace nicol
