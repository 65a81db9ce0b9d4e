// SPDX-License-Identifier: MIT
// What a ray meets: an instance in the world, and a point of it.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/ray_scene.hpp"
#include "reference/surface_sampler.hpp"
#include "scene/scene.hpp"

namespace nicol {

struct TracedSurface {
    struct Layer {
        const Material* material;
        const SurfaceSampler* sampler;
    };
    Mesh mesh;  ///< in the world
    const Material* material;
    std::vector<Layer> layers;   ///< of a material that varies; else itself
    const Emission* emission;    ///< null: it emits no light
    glm::dvec3 emission_axis{};  ///< of its polarization, in the world

    /// Valid as long as the surface stays where it is.
    [[nodiscard]] Presence presence() const;
    /// Of the hit's triangle and weights.
    [[nodiscard]] glm::dvec3 position(const RayHit& hit) const;
    /// Unit, of the triangle itself, to its front.
    [[nodiscard]] glm::dvec3 geometric_normal(const RayHit& hit) const;
    /// Unit, interpolated between the corners'.
    [[nodiscard]] glm::dvec3 normal(const RayHit& hit) const;
    /// The Stokes vectors, in each channel, of what it emits at a hit along z of `frame`. False where it is
    /// not there or emits no light that way, and `radiance` is left as it is.
    [[nodiscard]] bool emitted(const RayHit& hit, const Frame& frame, std::span<Stokes> radiance) const;
};

/// Where light is reflected.
struct SurfaceHit {
    const TracedSurface& surface;
    glm::dvec3 position;
    glm::dvec3 geometric_normal;
    glm::dvec3 unturned;  ///< the interpolated normal, on the side of the shading normal
    /// z = the shading normal, of a two-sided material on the viewer's side; of an anisotropic one x = where
    /// texture coordinate u grows.
    Frame frame;
    glm::dvec3 towards_viewer;  ///< in that frame
    TexturePoint point;
};
/// `towards_viewer` in the world, unit.
[[nodiscard]] SurfaceHit surface_hit(const TracedSurface& surface, const RayHit& hit,
                                     const glm::dvec3& towards_viewer);

}  // namespace nicol
