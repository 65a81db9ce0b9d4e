// SPDX-License-Identifier: MIT
#include "reference/boundary_event.hpp"

#include "material/reflectance.hpp"
#include "shading/boundary_split.hpp"

namespace nicol {

std::optional<BoundaryEvent> sample_boundary(const SmoothBoundary& boundary, const SurfaceHit& hit,
                                             const Frame& received, double point, PathWorkspace& workspace) {
    const BoundarySplit split = split_at(boundary, hit.geometric_normal, hit.frame[2], received);
    const double reflected = mean_factor(boundary.reflectance) * split.reflected.share;
    const double transmitted = mean_factor(boundary.transmittance) * split.transmitted.share;
    if (!(reflected + transmitted > 0)) return std::nullopt;
    const bool reflects = point * (reflected + transmitted) < reflected;
    const double probability = (reflects ? reflected : transmitted) / (reflected + transmitted);

    const BoundaryPart& part = reflects ? split.reflected : split.transmitted;
    const Mueller event = 1 / probability * part.mueller;
    const std::vector<double>& factors = reflects ? boundary.reflectance : boundary.transmittance;
    for (std::size_t c = 0; c < workspace.throughput.size(); ++c)
        workspace.throughput[c] =
            workspace.throughput[c] * (of_channel(factors, static_cast<int>(c)) * event);
    return BoundaryEvent{
        .ray = leaving(hit.position, hit.geometric_normal, part.towards_light, hit.ray_offset),
        .incident = part.incident,
        .radiance_scale = part.radiance_scale,
        .body = body_before(boundary, split, part, workspace.body)};
}

}  // namespace nicol
