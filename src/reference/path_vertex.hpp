// SPDX-License-Identifier: MIT
// Vertex of a path: a point of a surface that scatters light towards the previous vertex, or to the camera.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "geometry/ray_scene.hpp"
#include "polarization/mueller.hpp"
#include "reference/boundary_sampler.hpp"
#include "reference/traced_surface.hpp"

namespace nicol {

/// Buffers of a thread's current path, and the thread's count of rays.
struct PathWorkspace {
    /// Mueller matrix of each channel: from light at the path's end, in the frame there, to the camera.
    std::vector<Mueller> throughput;
    std::vector<Mueller> scattering;  ///< PathVertex::evaluate(), of each channel
    std::vector<Mueller> terms;
    std::vector<glm::vec3> weights;        ///< weights of the layers of the surface's material
    std::vector<double> shares;            ///< probability of each layer to be sampled
    std::vector<Stokes> incident;          ///< incident radiance of each channel
    std::vector<double> irradiance;        ///< irradiance of each channel
    const SmoothBoundary* body = nullptr;  ///< body that the path's end is in; null: none
    std::uint64_t shadow_rays = 0;

    /// Multiplies the incident radiance by what a body, or none, transmits over a distance, which may be
    /// infinite.
    void absorb(const SmoothBoundary* along, double distance);
};

/// Vertex at the end of the workspace's path. A workspace has one vertex at a time. Directions towards the
/// light are unit vectors in the surface's frame.
class PathVertex {
public:
    /// Moves the path's end from the light that leaves `hit`, in the frame `received`, into the frame in
    /// which the surface's material reflects. Keeps references to the arguments. A rough boundary that
    /// transmits light also scatters the light from behind the surface, and to a viewer there.
    PathVertex(const SurfaceHit& hit, const Frame& received, PathWorkspace& workspace);

    [[nodiscard]] const SurfaceHit& hit() const noexcept { return hit_; }
    [[nodiscard]] PathWorkspace& workspace() const noexcept { return workspace_; }

    [[nodiscard]] glm::dvec3 in_world(const glm::dvec3& towards_light) const;
    /// Returns the frame, in the world, of the light from a direction.
    [[nodiscard]] Frame incident_frame(const glm::dvec3& towards_light) const;
    /// Returns the ray from the point towards the light.
    [[nodiscard]] Ray ray(const glm::dvec3& towards_light) const;
    /// Returns whether the surface can send light from a direction to the viewer. A perturbed normal may face
    /// light from below the surface, which the surface hides.
    [[nodiscard]] bool lit_from(const glm::dvec3& towards_light) const;

    /// Returns whether the surface is a mirror: all terms of its material are smooth.
    [[nodiscard]] bool mirrors() const;
    /// Returns the direction whose light a mirror reflects to the viewer.
    [[nodiscard]] glm::dvec3 mirrored() const {
        return {-hit_.towards_viewer.x, -hit_.towards_viewer.y, hit_.towards_viewer.z};
    }

    /// Samples a direction towards the light. point: in [0, 1)^2. The direction may be one from which no
    /// light reaches the viewer, and then is not lit_from(); it may be zero.
    [[nodiscard]] glm::dvec3 sample(const glm::dvec2& point) const;
    /// Returns the density of sample() per steradian.
    [[nodiscard]] double pdf(const glm::dvec3& towards_light) const;

    /// Sets workspace().scattering to the pBRDF times the cosine, from incident_frame() to the path's end.
    /// sized: whether the light has a size; smooth terms do not reflect other lights.
    void evaluate(const glm::dvec3& towards_light, bool sized) const;
    /// Multiplies workspace().incident, light from a direction, by what the body on its way transmits over a
    /// distance, which may be infinite.
    void absorb(const glm::dvec3& towards_light, double distance) const;
    /// Adds the camera's share of workspace().incident, light from a direction in incident_frame(), whose
    /// density is `pdf`. The other arguments are those of evaluate().
    void add_reflected(const glm::dvec3& towards_light, double pdf, bool sized, std::span<Stokes> sum) const;
    /// Moves the path's end to the light from a direction, in incident_frame(), whose density is `pdf`.
    /// Returns BoundaryPart::radiance_scale.
    double extend(const glm::dvec3& towards_light, double pdf) const;
    /// Moves the path's end to the light from mirrored(), in incident_frame(), as a mirror reflects it.
    void extend_mirrored() const;

private:
    void weigh_layers() const;
    /// Returns the factor of light from a direction, for a perturbed normal.
    [[nodiscard]] double dimming(const glm::dvec3& towards_light) const;
    /// Adds what the rough boundary transmits, or reflects behind the surface, to workspace().scattering.
    void add_boundary(const glm::dvec3& towards_light) const;
    [[nodiscard]] bool crosses(const glm::dvec3& towards_light) const {
        return towards_light.z * hit_.towards_viewer.z < 0;
    }
    /// Returns the body that light from a direction travels through; null: none.
    [[nodiscard]] const SmoothBoundary* body_towards(const glm::dvec3& towards_light) const;

    const SurfaceHit& hit_;
    PathWorkspace& workspace_;
    const SmoothBoundary* boundary_;          // rough boundary that transmits light; null: none
    std::optional<BoundarySampler> passing_;  // if there is a boundary
};

}  // namespace nicol
