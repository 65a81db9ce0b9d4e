// SPDX-License-Identifier: MIT
#include "reference/lamp_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace nicol {
namespace {

/// The index whose share of a cumulative sum holds x; x becomes where in that share.
std::size_t choose(const std::vector<double>& cumulative, double& x) {
    // Below the last sum, so that an index without a share is never chosen.
    const double at = std::min(x * cumulative.back(), std::nextafter(cumulative.back(), 0.0));
    const auto found = std::upper_bound(cumulative.begin(), cumulative.end() - 1, at);
    const double before = found == cumulative.begin() ? 0 : *(found - 1);
    x = std::clamp((at - before) / (*found - before), 0.0, 1 - 1e-16);
    return static_cast<std::size_t>(found - cumulative.begin());
}

std::vector<double> cumulative_areas(const Mesh& mesh) {
    std::vector<double> areas;
    double sum = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        sum += glm::length(glm::cross(b - a, c - a)) / 2;
        areas.push_back(sum);
    }
    return areas;
}

/// Mean radiance over the surface and the channels.
double brightness(const Emission& emission) {
    const glm::vec4 mean = emission.texture != nullptr ? emission.texture->mean() : glm::vec4(1);
    double sum = 0;
    for (int c = 0; c < emission.channels(); ++c)
        sum += textured_value(emission.radiance, emission.texture, mean, c);
    return sum / emission.channels();
}

}  // namespace

LampSampler::LampSampler(std::span<const TracedSurface> surfaces) : densities_(surfaces.size(), 0) {
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
        const Emission* const emission = surfaces[s].emission;
        if (emission == nullptr) continue;
        Lamp lamp{.surface = s, .areas = cumulative_areas(surfaces[s].mesh), .power = 0};
        if (lamp.areas.empty()) continue;
        lamp.power = brightness(*emission) * lamp.areas.back() * (emission->two_sided ? 2 : 1);
        if (!(lamp.power > 0)) continue;
        powers_.push_back(lamp.power + (powers_.empty() ? 0 : powers_.back()));
        lamps_.push_back(std::move(lamp));
    }
    for (const Lamp& lamp : lamps_) {
        const double chance = lamps_.size() > kFew ? lamp.power / powers_.back() : 1;
        densities_[lamp.surface] = chance / lamp.areas.back();
    }
}

std::size_t LampSampler::samples() const noexcept {
    return lamps_.size() > kFew ? 1 : lamps_.size();
}

RayHit LampSampler::sample(std::size_t index, glm::dvec2 point) const {
    const Lamp& lamp = lamps_[lamps_.size() > kFew ? choose(powers_, point.x) : index];
    const auto triangle = static_cast<std::uint32_t>(choose(lamp.areas, point.x));
    const double root = std::sqrt(point.x);
    return {.surface = lamp.surface,
            .triangle = triangle,
            .distance = 0,
            .b1 = root * (1 - point.y),
            .b2 = root * point.y};
}

}  // namespace nicol
