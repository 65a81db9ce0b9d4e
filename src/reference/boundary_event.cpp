// SPDX-License-Identifier: MIT
#include "reference/boundary_event.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "geometry/perpendicular.hpp"
#include "material/reflectance.hpp"
#include "polarization/fresnel.hpp"
#include "polarization/slab.hpp"

namespace nicol {
namespace {

/// Directions, in the world, of the light that a boundary sends to the viewer.
struct BoundaryRays {
    double cosine;  ///< cosine between the normal and the direction towards the viewer
    glm::dvec3 reflected;
    glm::dvec3 transmitted;  ///< undefined under total reflection
    bool total;              ///< whether the boundary reflects all light
};

/// eta: index of the far side relative to the viewer's side. normal: unit vector on the viewer's side.
BoundaryRays rays_at(double eta, SmoothBoundary::Behind behind, const glm::dvec3& normal,
                     const glm::dvec3& towards_viewer) {
    const double cosine = std::min(1.0, glm::dot(normal, towards_viewer));
    const double square = eta * eta - 1 + cosine * cosine;
    BoundaryRays out{.cosine = cosine,
                     .reflected = glm::normalize(2 * cosine * normal - towards_viewer),
                     .transmitted = -towards_viewer,
                     .total = !(square > 0)};
    // Snell's law: eta times the cosine of refraction is the root.
    if (behind == SmoothBoundary::Behind::body && !out.total)
        out.transmitted = glm::normalize((cosine - std::sqrt(square)) * normal - towards_viewer);
    return out;
}

/// Returns whether the directions lie on their sides of the surface. side: the surface's own normal, on the
/// viewer's side. An interpolated normal may point a reflection into the surface.
bool consistent(const BoundaryRays& rays, const glm::dvec3& side) {
    return rays.cosine > 0 && glm::dot(rays.reflected, side) > 0 &&
           (rays.total || glm::dot(rays.transmitted, side) < 0);
}

double mean(const std::vector<double>& factors) {
    return std::accumulate(factors.begin(), factors.end(), 0.0) / static_cast<double>(factors.size());
}

}  // namespace

std::optional<BoundaryEvent> sample_boundary(const SmoothBoundary& boundary, const SurfaceHit& hit,
                                             const Frame& received, double point, PathWorkspace& workspace) {
    const bool slab = boundary.behind == SmoothBoundary::Behind::slab;
    const glm::dvec3 towards_viewer = received[2];
    // The interpolated normal says which side of the triangle is its front.
    glm::dvec3 side = hit.geometric_normal;
    if (glm::dot(side, hit.frame[2]) < 0) side = -side;
    glm::dvec3 normal = hit.frame[2];
    const bool inside = glm::dot(side, towards_viewer) < 0;
    if (inside) {
        side = -side;
        normal = -normal;
    }
    const double eta = inside && !slab ? 1 / boundary.eta : boundary.eta;
    BoundaryRays rays = rays_at(eta, boundary.behind, normal, towards_viewer);
    if (!consistent(rays, side)) {
        normal = side;
        rays = rays_at(eta, boundary.behind, normal, towards_viewer);
    }

    const SlabSplit split = slab ? slab_split(rays.cosine, eta)
                                 : SlabSplit{.reflection = fresnel_reflection(rays.cosine, eta),
                                             .transmission = fresnel_transmission(rays.cosine, eta)};
    const double reflected = mean(boundary.reflectance) * split.reflection(0, 0);
    const double transmitted = mean(boundary.transmittance) * split.transmission(0, 0);
    if (!(reflected + transmitted > 0)) return std::nullopt;
    const bool reflects = point * (reflected + transmitted) < reflected;
    const double probability = (reflects ? reflected : transmitted) / (reflected + transmitted);

    const glm::dvec3 towards_light = reflects ? rays.reflected : rays.transmitted;
    const glm::dvec3 s_axis = perpendicular(towards_viewer, glm::cross(normal, towards_viewer));
    const Frame incident = frame_with_x(-towards_light, s_axis);
    const double scale = reflects || slab ? 1 : 1 / (eta * eta);
    const Mueller event = frame_rotation(angle_between(frame_with_x(towards_viewer, s_axis), received)) *
                          (scale / probability * (reflects ? split.reflection : split.transmission));
    const std::vector<double>& factors = reflects ? boundary.reflectance : boundary.transmittance;
    for (std::size_t c = 0; c < workspace.throughput.size(); ++c)
        workspace.throughput[c] =
            workspace.throughput[c] * (of_channel(factors, static_cast<int>(c)) * event);
    return BoundaryEvent{.ray = leaving(hit.position, hit.geometric_normal, towards_light, hit.ray_offset),
                         .incident = incident,
                         .radiance_scale = scale};
}

}  // namespace nicol
