// SPDX-License-Identifier: MIT
#include "shading/glass_shadows.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>
#include <vector>

#include "material/reflectance.hpp"
#include "polarization/fresnel.hpp"
#include "shading/boundary_split.hpp"

namespace nicol {
namespace {

// Boundaries on a ray after which the light is left as it is.
constexpr int kMostCrossings = 64;

/// Returns the transmittance of a boundary for unpolarized light at an angle outside, in a channel.
double transmittance_at(const SmoothBoundary& boundary, double cosine, int channel) {
    if (boundary.film || boundary.behind == SmoothBoundary::Behind::slab)
        return split_of(boundary, cosine, false, channel).transmission(0, 0);
    return 1 - fresnel_reflection(cosine, boundary.eta)(0, 0);
}

void multiply(LaneLight& light, std::size_t channel, std::size_t point, double factor) {
    for (std::size_t p = 0; p < light.components; ++p)
        light.irradiance[channel][p][point] *= static_cast<float>(factor);
}

}  // namespace

GlassShadows::GlassShadows(std::shared_ptr<const RayScene> surfaces, FirstCrossing first)
    : surfaces_(std::move(surfaces)), first_(std::move(first)) {}

template <class Apply>
bool GlassShadows::for_crossings(Ray ray, const Apply& apply) const {
    double entered = 0;
    for (int i = 0; i < kMostCrossings; ++i) {
        const std::optional<Crossing> met = first_(ray);
        if (!met) return true;
        if (met->boundary == nullptr) return false;
        const SmoothBoundary& boundary = *met->boundary;
        const double along = glm::dot(met->normal, ray.direction);
        const double cosine = std::min(1.0, std::abs(along));
        const double transmitted = transmittance_at(boundary, cosine, 0);
        const double length = along > 0 ? met->distance - entered : 0;
        apply(
            [&](int c) {
                const double inside = length > 0 ? transmitted_by(&boundary, c, length) : 1.0;
                const double passes = boundary.film ? transmittance_at(boundary, cosine, c) : transmitted;
                return passes * of_channel(boundary.transmittance, c) * inside;
            },
            static_cast<std::size_t>(std::max({static_cast<int>(boundary.transmittance.size()),
                                               static_cast<int>(boundary.absorption.size()),
                                               boundary.film ? boundary.film->channels() : 1})));
        entered = met->distance;
        ray.nearest = met->distance + met->offset;
    }
    return true;
}

void GlassShadows::dim(const RayPacket& packet, std::uint32_t points, LaneLight& light) const {
    const std::uint32_t behind = surfaces_->occluded(packet, static_cast<std::uint16_t>(points));
    for (std::size_t i = 0; i < RayPacket::kRays; ++i) {
        if ((behind >> i & 1) == 0) continue;
        const auto multiply_all = [&](const auto& factor_of, std::size_t channels) {
            if (channels > light.irradiance.size())
                light.irradiance.resize(channels, light.irradiance.front());
            for (std::size_t c = 0; c < light.irradiance.size(); ++c)
                multiply(light, c, i, factor_of(static_cast<int>(c)));
        };
        const bool open =
            for_crossings({.origin = glm::dvec3(packet.origin_x[i], packet.origin_y[i], packet.origin_z[i]),
                           .direction = glm::normalize(glm::dvec3(
                               packet.direction_x[i], packet.direction_y[i], packet.direction_z[i])),
                           .farthest = static_cast<double>(packet.farthest[i])},
                          multiply_all);
        if (!open) multiply_all([](int /*channel*/) { return 0.0; }, 1);
    }
}

double GlassShadows::transmittance(Ray ray) const {
    thread_local std::vector<double> of_channels;
    of_channels.assign(1, 1.0);
    const bool open = for_crossings(ray, [&](const auto& factor_of, std::size_t channels) {
        if (channels > of_channels.size()) of_channels.resize(channels, of_channels.front());
        for (std::size_t c = 0; c < of_channels.size(); ++c) of_channels[c] *= factor_of(static_cast<int>(c));
    });
    if (!open) return 0;
    return std::accumulate(of_channels.begin(), of_channels.end(), 0.0) /
           static_cast<double>(of_channels.size());
}

}  // namespace nicol
