// SPDX-License-Identifier: MIT
#include "methods/receiver_areas.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "material/spatial_variation.hpp"
#include "shading/light_samples.hpp"
#include "surfaces/triangle_point.hpp"

namespace nicol {
namespace {

// Points of a triangle by which its mask takes area from receivers.
constexpr std::size_t kMaskPoints = 16;

// Returns the means over a triangle of the weights of its corners, which are 0 where a mask leaves nothing.
glm::dvec3 present_weights(const Presence& present, std::uint32_t triangle) {
    if (!present) return glm::dvec3(1.0 / 3);
    const std::uint32_t seed = sample_seed(triangle, 0);
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < kMaskPoints; ++i) {
        Lanes u, v;
        light_samples(static_cast<std::uint32_t>(i), std::span(&seed, 1), u, v);
        const float root = std::sqrt(u[0]);
        const float b1 = root * (1 - v[0]), b2 = root * v[0];
        if (present(triangle, b1, b2)) sum += glm::dvec3(1 - b1 - b2, b1, b2);
    }
    return sum / static_cast<double>(kMaskPoints);
}

}  // namespace

std::vector<double> areas_of_receivers(const WorldGeometry& geometry, const LinkedSurfaces& surfaces,
                                       const Presence& present) {
    std::vector<double> out(surfaces.receivers());
    for (const TriangleBatch& batch : triangle_batches(geometry)) {
        const bool masked = opacity_of(*geometry.ranges[batch.range].material) != nullptr;
        for (std::size_t n = batch.first; n < batch.last; ++n) {
            const auto t = static_cast<std::uint32_t>(n);
            const glm::dvec3 areas =
                glm::length(area_vector(geometry, t)) * present_weights(masked ? present : Presence(), t);
            for (glm::length_t k = 0; k < 3; ++k) {
                const Receivers::Blend& blend = surfaces.blends()[geometry.triangles[t][k]];
                for (std::size_t i = 0; i < blend.weights.size(); ++i)
                    if (blend.weights[i] > 0) out[blend.receivers[i]] += areas[k] * double{blend.weights[i]};
            }
        }
    }
    return out;
}

}  // namespace nicol
