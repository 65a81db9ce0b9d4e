// SPDX-License-Identifier: MIT
#include "shading/rough_boundary.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/perpendicular.hpp"
#include "material/microfacet.hpp"
#include "polarization/fresnel.hpp"

namespace nicol {
namespace {

glm::dvec3 mirrored(const glm::dvec3& direction) {
    return {direction.x, direction.y, -direction.z};
}

/// Returns a direction, of any side of the surface, on the front.
glm::dvec3 on_front(const glm::dvec3& direction) {
    return direction.z < 0 ? mirrored(direction) : direction;
}

double visible_fraction(const SmoothBoundary& boundary, double cosine) {
    return facet_visibility(boundary.distribution, boundary.alpha, std::abs(cosine));
}

bool is_slab(const SmoothBoundary& boundary) {
    return boundary.behind == SmoothBoundary::Behind::slab;
}

/// Returns the index of the far side relative to the viewer's.
double index_beyond(const SmoothBoundary& boundary, const glm::dvec3& towards_viewer) {
    return towards_viewer.z < 0 && !is_slab(boundary) ? 1 / boundary.eta : boundary.eta;
}

}  // namespace

glm::dvec3 facet_between(const SmoothBoundary& boundary, const glm::dvec3& towards_light,
                         const glm::dvec3& towards_viewer) {
    const bool transmits = towards_light.z * towards_viewer.z < 0;
    glm::dvec3 sum = towards_viewer + towards_light;
    if (transmits && is_slab(boundary)) sum = towards_viewer + mirrored(towards_light);
    if (transmits && !is_slab(boundary))
        sum = towards_viewer + index_beyond(boundary, towards_viewer) * towards_light;
    if (sum.z * towards_viewer.z < 0) sum = -sum;
    const double length = glm::length(sum);
    if (!(length > 1e-9)) return glm::dvec3(0.0);
    const glm::dvec3 facet = sum / length;
    // Refraction crosses the facet, and reflection does not.
    const double to_light =
        glm::dot(facet, transmits && is_slab(boundary) ? mirrored(towards_light) : towards_light);
    const bool crosses = transmits && !is_slab(boundary);
    if (!(glm::dot(facet, towards_viewer) > 0) || !(crosses ? to_light < 0 : to_light > 0))
        return glm::dvec3(0.0);
    return facet;
}

Mueller rough_scattering(const SmoothBoundary& boundary, const glm::dvec3& towards_light,
                         const glm::dvec3& towards_viewer, int channel) {
    const glm::dvec3 facet = facet_between(boundary, towards_light, towards_viewer);
    if (facet == glm::dvec3(0.0) || towards_light.z == 0 || towards_viewer.z == 0) return {};
    const bool transmits = towards_light.z * towards_viewer.z < 0;
    const double cosine = std::min(1.0, glm::dot(facet, towards_viewer));
    const double eta = index_beyond(boundary, towards_viewer);
    const double facets = facet_density(boundary.distribution, glm::dvec2(boundary.alpha), on_front(facet)) *
                          visible_fraction(boundary, towards_light.z) *
                          visible_fraction(boundary, towards_viewer.z) /
                          std::abs(towards_light.z * towards_viewer.z);
    const glm::dvec3 s_axis = perpendicular(towards_viewer, glm::cross(facet, towards_viewer));
    glm::dvec3 incident_s = s_axis;
    const auto by_facet = [&] { return split_of(boundary, cosine, towards_viewer.z < 0, channel); };
    Mueller m;
    if (is_slab(boundary)) {
        const SlabSplit split = by_facet();
        m = facets / 4 * (transmits ? split.transmission : split.reflection);
        if (transmits) incident_s = mirrored(s_axis);
    } else if (transmits) {
        const double to_light = -glm::dot(facet, towards_light);
        const double spread = cosine - eta * to_light;
        m = facets * cosine * to_light / (spread * spread) *
            (boundary.film ? by_facet().transmission : fresnel_transmission(cosine, eta));
    } else {
        m = facets / 4 * (boundary.film ? by_facet().reflection : fresnel_reflection(cosine, eta));
    }
    const Mueller out_of_s =
        frame_rotation(angle_between(frame_with_x(towards_viewer, s_axis), theta_phi_frame(towards_viewer)));
    const Mueller into_s = frame_rotation(
        angle_between(theta_phi_frame(-towards_light), frame_with_x(-towards_light, incident_s)));
    return out_of_s * (m * into_s);
}

BoundarySplit split_at_facet(const SmoothBoundary& boundary, const glm::dvec3& geometric,
                             const glm::dvec3& normal, const Frame& received, const glm::dvec2& point) {
    const glm::dvec3 towards_viewer = received[2];
    const ViewedSide viewed = viewed_side(geometric, normal, towards_viewer);
    const glm::dvec3& side = viewed.side;
    const glm::dvec3& facing = glm::dot(viewed.facing, towards_viewer) > 0 ? viewed.facing : side;
    const Frame frame = theta_phi_frame(facing);
    const glm::dvec3 viewer = glm::normalize(towards_viewer * frame);
    const glm::dvec3 facet = visible_facet(glm::dvec2(boundary.alpha), viewer, point);
    const glm::dvec3 facet_normal = glm::normalize(frame * facet);

    BoundarySplit out =
        split_at(boundary, facet_normal, viewed.inside ? -facet_normal : facet_normal, received);
    out.inside = viewed.inside;
    out.normal = facing;
    if (is_slab(boundary)) {
        const glm::dvec3 beyond =
            glm::normalize(frame * mirrored(glm::normalize(out.reflected.towards_light * frame)));
        const glm::dvec3 s_axis = frame * mirrored(glm::normalize(out.reflected.incident[0] * frame));
        out.transmitted.towards_light = beyond;
        out.transmitted.incident = frame_with_x(-beyond, perpendicular(beyond, s_axis));
    }
    // GGX facets stand for those of the boundary's own distribution.
    const auto density_of_visible = [&](Distribution distribution) {
        return facet_density(distribution, glm::dvec2(boundary.alpha), facet) *
               facet_visibility(distribution, boundary.alpha, viewer.z);
    };
    const double ratio =
        boundary.distribution == Distribution::ggx
            ? 1.0
            : density_of_visible(boundary.distribution) / density_of_visible(Distribution::ggx);
    const auto weigh = [&](BoundaryPart& part, double sign) {
        const double cosine = glm::dot(part.towards_light, facing);
        const bool leaves = sign * cosine > 0 && sign * glm::dot(part.towards_light, side) > 0;
        const double weight = leaves ? ratio * visible_fraction(boundary, cosine) : 0.0;
        part.mueller = weight * part.mueller;
        part.weight = weight;
        part.share *= weight;
    };
    weigh(out.reflected, 1);
    weigh(out.transmitted, -1);
    return out;
}

}  // namespace nicol
