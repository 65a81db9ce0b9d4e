// SPDX-License-Identifier: MIT
#include "surfaces/focusing_surfaces.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <span>
#include <utility>

#include "material/dielectric.hpp"
#include "material/reflectance.hpp"
#include "material/spatial_variation.hpp"
#include "shading/light_samples.hpp"
#include "surfaces/photon_rays.hpp"
#include "surfaces/triangle_point.hpp"

namespace nicol {
namespace {

// Returns a point of [0, 1)^2: of a sequence that fills the square evenly, as if by chance of the seed.
glm::vec2 sample_at(std::size_t index, std::uint32_t seed) {
    Lanes u, v;
    const std::uint32_t mixed = sample_seed(seed, 0);
    light_samples(static_cast<std::uint32_t>(index), std::span(&mixed, 1), u, v);
    return {u[0], v[0]};
}

}  // namespace

FocusingSurface::Place FocusingSurface::place(std::size_t i, std::size_t count) const {
    const double per_area = static_cast<double>(count) / areas.back();
    const double area = (static_cast<double>(i) + 0.5) / per_area;
    const auto after = std::ranges::upper_bound(areas, area) - areas.begin();
    const auto chosen = std::min(static_cast<std::size_t>(after), triangles.size() - 1);
    const double before = chosen > 0 ? areas[chosen - 1] : 0;
    const auto first = static_cast<std::size_t>(std::ceil(std::max(0.0, before * per_area - 0.5)));
    const std::size_t index = i - std::min(i, first);
    const glm::dvec2 point(sample_at(index, triangles[chosen]));
    // Each block of a power of two of consecutive points fills the triangle evenly, so that points near each
    // other are of different blocks. Some 64 blocks choose in turn.
    constexpr double blocks = 64;
    const double paths = (areas[chosen] - before) * per_area;
    const std::size_t block = std::bit_floor(static_cast<std::size_t>(std::max(1.0, paths / blocks)));
    const std::size_t turns = index / block + first;
    const auto turn = static_cast<double>(turns);
    const double root = std::sqrt(point.x);
    return {.triangle = triangles[chosen],
            .b1 = root * (1 - point.y),
            .b2 = root * point.y,
            .choice = glm::fract(turn * std::numbers::phi)};
}

bool focuses_light(const Material& material) {
    const SmoothBoundary* const boundary = material.smooth_boundary();
    if (boundary != nullptr) return !boundary->rough();
    return material.variation() == nullptr && material.terms() > 0 && is_mirror(material);
}

std::vector<FocusingSurface> focusing_surfaces(const WorldGeometry& geometry) {
    std::vector<FocusingSurface> out;
    for (const TriangleBatch& batch : triangle_batches(geometry)) {
        const VertexRange& range = geometry.ranges[batch.range];
        if (!PhotonRays::blocks(range) || !focuses_light(*range.material)) continue;
        FocusingSurface surface{batch.range, {}, {}};
        surface.triangles.reserve(batch.last - batch.first);
        surface.areas.reserve(batch.last - batch.first);
        double area = 0;
        for (std::size_t t = batch.first; t < batch.last; ++t) {
            surface.triangles.push_back(static_cast<std::uint32_t>(t));
            area += glm::length(area_vector(geometry, surface.triangles.back()));
            surface.areas.push_back(area);
        }
        if (area > 0) out.push_back(std::move(surface));
    }
    return out;
}

}  // namespace nicol
