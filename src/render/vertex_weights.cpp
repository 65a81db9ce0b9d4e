// SPDX-License-Identifier: MIT
#include "render/vertex_weights.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace nicol {
namespace {

// Vertices in the samples of all materials together, and fewest in one.
constexpr double kSamples = 512;
constexpr double kFewest = 32;

std::vector<double> weights_of(const WorldGeometry& geometry) {
    std::vector<double> areas(geometry.positions.size(), 0.0);
    double all = 0;
    for (const glm::uvec3& t : geometry.triangles) {
        const glm::dvec3 corner(geometry.positions[t.x]);
        const double area = glm::length(glm::cross(glm::dvec3(geometry.positions[t.y]) - corner,
                                                   glm::dvec3(geometry.positions[t.z]) - corner));
        for (const std::uint32_t v : {t.x, t.y, t.z}) areas[v] += area;
        all += 3 * area;
    }
    const double unit = all > 0 ? static_cast<double>(areas.size()) / all : 0;
    for (double& weight : areas) weight = 0.5 + 0.5 * unit * weight;
    return areas;
}

}  // namespace

VertexWeights::VertexWeights(const WorldGeometry& geometry, std::span<const std::uint8_t> baked) {
    const std::vector<double> weights = weights_of(geometry);
    std::map<MaterialPtr, double> baked_weights;
    const auto is_baked = [baked](std::size_t v) { return baked.empty() || baked[v] != 0; };
    std::map<MaterialPtr, std::vector<const VertexRange*>> ranges;
    for (const VertexRange& range : geometry.ranges) {
        ranges[range.material].push_back(&range);
        double& weight = groups_[range.material].weight;
        double& baked_weight = baked_weights[range.material];
        for (std::size_t v = range.first; v < range.last; ++v) {
            weight += weights[v];
            if (is_baked(v)) baked_weight += weights[v];
        }
    }
    for (auto& [material, group] : groups_) {
        const double wanted = kSamples * group.weight / static_cast<double>(weights.size());
        const double from = baked_weights[material];
        const double step = (from > 0 ? from : group.weight) / std::ceil(std::max(wanted, kFewest));
        // The vertices in which the sum of weights passes the middle of each step.
        double passed = 0;
        for (const VertexRange* const range : ranges[material])
            for (std::size_t v = range->first; v < range->last; ++v) {
                if (from > 0 && !is_baked(v)) continue;
                passed += weights[v];
                const auto reached = static_cast<std::size_t>(std::max(0.0, std::ceil(passed / step - 0.5)));
                if (group.sample.size() < reached)
                    group.sample.resize(reached, static_cast<std::uint32_t>(v));
            }
    }
}

}  // namespace nicol
