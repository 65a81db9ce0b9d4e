// SPDX-License-Identifier: MIT
#include "shading/glass_shadows.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "material/reflectance.hpp"
#include "polarization/fresnel.hpp"
#include "polarization/slab.hpp"
#include "shading/boundary_split.hpp"

namespace nicol {
namespace {

// Boundaries on a ray after which the light is left as it is.
constexpr int kMostCrossings = 64;

/// Returns the transmittance of a boundary for unpolarized light at an angle outside.
double transmittance_at(const SmoothBoundary& boundary, double cosine) {
    if (boundary.behind == SmoothBoundary::Behind::slab)
        return slab_split(cosine, boundary.eta).transmission(0, 0);
    return 1 - fresnel_reflection(cosine, boundary.eta)(0, 0);
}

void multiply(LaneLight& light, std::size_t channel, std::size_t point, double factor) {
    for (std::size_t p = 0; p < light.components; ++p)
        light.irradiance[channel][p][point] *= static_cast<float>(factor);
}

}  // namespace

GlassShadows::GlassShadows(std::shared_ptr<const RayScene> surfaces, FirstCrossing first)
    : surfaces_(std::move(surfaces)), first_(std::move(first)) {}

void GlassShadows::dim(const RayPacket& packet, std::uint32_t points, LaneLight& light) const {
    const std::uint32_t behind = surfaces_->occluded(packet, static_cast<std::uint16_t>(points));
    for (std::size_t i = 0; i < RayPacket::kRays; ++i) {
        if ((behind >> i & 1) == 0) continue;
        dim({.origin = glm::dvec3(packet.origin_x[i], packet.origin_y[i], packet.origin_z[i]),
             .direction = glm::normalize(
                 glm::dvec3(packet.direction_x[i], packet.direction_y[i], packet.direction_z[i])),
             .farthest = static_cast<double>(packet.farthest[i])},
            i, light);
    }
}

void GlassShadows::dim(Ray ray, std::size_t point, LaneLight& light) const {
    const auto apply = [&](const auto& factor_of, std::size_t channels) {
        if (channels > light.irradiance.size()) light.irradiance.resize(channels, light.irradiance.front());
        for (std::size_t c = 0; c < light.irradiance.size(); ++c)
            multiply(light, c, point, factor_of(static_cast<int>(c)));
    };
    double entered = 0;
    for (int i = 0; i < kMostCrossings; ++i) {
        const std::optional<Crossing> met = first_(ray);
        if (!met || met->boundary == nullptr) return;
        const SmoothBoundary& boundary = *met->boundary;
        const double along = glm::dot(met->normal, ray.direction);
        const double transmitted = transmittance_at(boundary, std::min(1.0, std::abs(along)));
        const double length = along > 0 ? met->distance - entered : 0;
        apply(
            [&](int c) {
                const double inside = length > 0 ? transmitted_by(&boundary, c, length) : 1.0;
                return transmitted * of_channel(boundary.transmittance, c) * inside;
            },
            std::max(boundary.transmittance.size(), boundary.absorption.size()));
        entered = met->distance;
        ray.nearest = met->distance + met->offset;
    }
}

}  // namespace nicol
