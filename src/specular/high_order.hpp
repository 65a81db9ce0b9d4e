// SPDX-License-Identifier: MIT
// Reflection of high orders of light: evaluates filtered maps at the mirrored view direction.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "polarization/views.hpp"
#include "specular/high_order_factors.hpp"
#include "specular/high_order_visibility.hpp"
#include "specular/lane_taps.hpp"
#include "specular/lobe_map.hpp"
#include "visibility/visibility_blocks.hpp"

namespace nicol {

/// Visibility by which high orders are multiplied.
struct HighOrderShadows {
    /// Visible fractions of the lobe about the mirror direction and of the hemisphere, 0..1, by vertex.
    /// Empty: `visibility` and `seen` determine the fractions; they are 1 if `visibility` is null.
    std::span<const glm::vec2> fractions;
    const HighOrderVisibility* visibility = nullptr;  ///< null: only `fractions` count
    const VisibilityBlocks* seen = nullptr;           ///< coefficients for `visibility`
};

/// Reflection of the light's orders above l_low.
class HighOrder {
public:
    /// Keeps references. light_to_world rotates the maps' axes into the world's. Throws
    /// Error(invalid_argument) if a map is missing, or maps or channels do not fit each other.
    HighOrder(const HighOrderFactors& factors, const HighOrderMaps& maps, const glm::dmat3& light_to_world);

    /// Adds Stokes vectors, in the camera's frame field, to out[c][v] for every vertex first <= v < last with
    /// visible[v] != 0. Calls for different vertices may run side by side.
    void run(const Views& views, std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
             std::span<const std::uint8_t> visible, const HighOrderShadows& shadows, std::size_t first,
             std::size_t last, std::span<const std::span<glm::vec4>> out) const;

private:
    const HighOrderFactors& factors_;
    HighOrderMaps maps_;
    glm::dmat3 world_to_light_;
};

}  // namespace nicol
