// SPDX-License-Identifier: MIT
// What surfaces are shaded by.
#pragma once

#include <set>
#include <span>
#include <vector>

#include "material/spatial_variation.hpp"
#include "surfaces/geometry.hpp"

namespace nicol {

/// The materials that are the same everywhere of which a surface's is made: those of its layers, in their
/// order, or itself.
[[nodiscard]] inline std::vector<MaterialPtr> plain_materials(const MaterialPtr& material) {
    const SpatialVariation* const variation = material->variation();
    if (variation == nullptr) return {material};
    std::vector<MaterialPtr> out;
    for (const MaterialLayer& layer : variation->layers) out.push_back(layer.material);
    return out;
}

/// Those of all ranges, each once.
[[nodiscard]] inline std::vector<MaterialPtr> plain_materials(std::span<const VertexRange> ranges) {
    std::vector<MaterialPtr> out;
    std::set<MaterialPtr> known;
    for (const VertexRange& range : ranges)
        for (const MaterialPtr& material : plain_materials(range.material))
            if (known.insert(material).second) out.push_back(material);
    return out;
}

}  // namespace nicol
