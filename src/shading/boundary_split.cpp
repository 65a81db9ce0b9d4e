// SPDX-License-Identifier: MIT
#include "shading/boundary_split.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/perpendicular.hpp"
#include "material/reflectance.hpp"
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

}  // namespace

ViewedSide viewed_side(const glm::dvec3& geometric, const glm::dvec3& normal,
                       const glm::dvec3& towards_viewer) {
    // The interpolated normal says which side of the triangle is its front.
    const glm::dvec3 front = glm::dot(geometric, normal) < 0 ? -geometric : geometric;
    const bool inside = glm::dot(front, towards_viewer) < 0;
    return inside ? ViewedSide{-front, -normal, true} : ViewedSide{front, normal, false};
}

BoundarySplit split_at(const SmoothBoundary& boundary, const glm::dvec3& geometric, const glm::dvec3& normal,
                       const Frame& received) {
    const bool slab = boundary.behind == SmoothBoundary::Behind::slab;
    const glm::dvec3 towards_viewer = received[2];
    auto [side, facing, inside] = viewed_side(geometric, normal, towards_viewer);
    const double eta = inside && !slab ? 1 / boundary.eta : boundary.eta;
    BoundaryRays rays = rays_at(eta, boundary.behind, facing, towards_viewer);
    if (!consistent(rays, side)) {
        facing = side;
        rays = rays_at(eta, boundary.behind, facing, towards_viewer);
    }

    const SlabSplit split = mean_split_of(boundary, rays.cosine, inside);
    const glm::dvec3 s_axis = perpendicular(towards_viewer, glm::cross(facing, towards_viewer));
    const Mueller into_received =
        frame_rotation(angle_between(frame_with_x(towards_viewer, s_axis), received));
    const auto part = [&](const glm::dvec3& towards_light, const Mueller& mueller, double scale) {
        return BoundaryPart{.towards_light = towards_light,
                            .incident = frame_with_x(-towards_light, s_axis),
                            .mueller = into_received * (scale * mueller),
                            .share = mueller(0, 0),
                            .radiance_scale = scale};
    };
    return {.reflected = part(rays.reflected, split.reflection, 1),
            .transmitted = part(rays.transmitted, split.transmission, slab ? 1 : 1 / (eta * eta)),
            .normal = facing,
            .eta = eta,
            .inside = inside,
            .into_received = boundary.film ? into_received : Mueller{},
            .cosine = rays.cosine};
}

Mueller mueller_of(const SmoothBoundary& boundary, const BoundarySplit& split, const BoundaryPart& part,
                   int channel) {
    if (!boundary.film) return part.mueller;
    const SlabSplit own = split_of(boundary, split.cosine, split.inside, channel);
    const bool reflects = &part == &split.reflected;
    return split.into_received *
           (part.radiance_scale * part.weight * (reflects ? own.reflection : own.transmission));
}

const SmoothBoundary* body_before(const SmoothBoundary& boundary, const BoundarySplit& split,
                                  const BoundaryPart& part, const SmoothBoundary* around) {
    return body_before(boundary, split.inside, &part == &split.reflected, around);
}

double transmitted_by(const SmoothBoundary* body, int channel, double distance) {
    if (body == nullptr) return 1;
    const double absorption = of_channel(body->absorption, channel);
    // The product is not a number for no absorption over an infinite distance.
    return absorption > 0 ? std::exp(-absorption * distance) : 1;
}

}  // namespace nicol
