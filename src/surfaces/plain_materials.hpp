// SPDX-License-Identifier: MIT
// Plain materials: the materials without spatial variation that surfaces consist of.
#pragma once

#include <set>
#include <span>
#include <vector>

#include "material/spatial_variation.hpp"
#include "surfaces/geometry.hpp"

namespace nicol {

/// Returns the plain materials of a material: the materials of its layers, in their order, or the material
/// itself if it has no spatial variation.
[[nodiscard]] inline std::vector<MaterialPtr> plain_materials(const MaterialPtr& material) {
    const SpatialVariation* const variation = material->variation();
    if (variation == nullptr) return {material};
    std::vector<MaterialPtr> out;
    for (const MaterialLayer& layer : variation->layers) out.push_back(layer.material);
    return out;
}

/// Returns the plain materials of all ranges, without duplicates.
[[nodiscard]] inline std::vector<MaterialPtr> plain_materials(std::span<const VertexRange> ranges) {
    std::vector<MaterialPtr> out;
    std::set<MaterialPtr> known;
    for (const VertexRange& range : ranges)
        for (const MaterialPtr& material : plain_materials(range.material))
            if (known.insert(material).second) out.push_back(material);
    return out;
}

}  // namespace nicol
