// SPDX-License-Identifier: MIT
// Reflection of high orders of light by several weighted materials.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "polarization/views.hpp"
#include "specular/high_order_factors.hpp"
#include "specular/lane_taps.hpp"
#include "specular/mixture_rows.hpp"

namespace nicol {

/// Layers of a material, each times weights: the weighted sum of the layers' HighOrder results. Light is
/// evaluated once for all layers with equal maps and spread.
class HighOrderLayers {
public:
    struct Layer {
        const HighOrderFactors* factors;
        HighOrderMaps maps;
    };
    /// Keeps references. The layers must satisfy the constraints of HighOrder. light_to_world rotates the
    /// maps' axes into the world's.
    HighOrderLayers(const std::vector<Layer>& layers, const glm::dmat3& light_to_world);

    /// Adds Stokes vectors, in the camera's frame field, to out[c][v] for all positions. weights: [block of
    /// sixteen][layer]. fractions: visible fractions of the lobe about the mirror direction and of the
    /// hemisphere, or empty.
    void run(const Views& views, std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
             std::span<const LayerWeights> weights, std::span<const glm::vec2> fractions,
             std::span<const std::span<glm::vec4>> out) const;

private:
    struct Member {
        std::size_t layer;
        const HighOrderFactors* factors;
    };
    // Layers with equal taps.
    struct Group {
        HighOrderMaps maps;
        double spread;
        std::vector<Member> members;
    };
    // Values that all groups of a block share.
    struct Block;

    void add_group(const Group& group, std::span<const LayerWeights> weights, const Block& block,
                   std::span<const std::span<glm::vec4>> out) const;

    std::size_t layers_;
    std::vector<Group> groups_;
    glm::dmat3 world_to_light_;
};

}  // namespace nicol
