// SPDX-License-Identifier: MIT
// Visible fractions of the lobes through which vertices reflect light to a viewer.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "polarization/viewpoint.hpp"
#include "specular/lane_mirror.hpp"
#include "visibility/visibility_blocks.hpp"

namespace nicol {

/// Filter of visibility that gives the fractions for HighOrder.
class HighOrderVisibility {
public:
    /// Takes the order of the visibility. width: that of the lobe about the mirror direction, radians, as for
    /// gaussian_gains(); it is widened if the order cannot resolve it. Throws Error(invalid_argument) for an
    /// order out of 0..64 or a width out of 0..4.
    HighOrderVisibility(int order, double width);

    /// Writes the visible fractions, 0..1, of a lobe about the mirrored view direction and of the cosine
    /// about the normal to out[v], for first <= v < last with visible[v] != 0. Both fractions are 1 at
    /// unoccluded vertices. `seen` must have the order of this object. Calls for different vertices may run
    /// side by side.
    void run(const Viewpoint& view, std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
             std::span<const std::uint8_t> visible, const VisibilityBlocks& seen, std::size_t first,
             std::size_t last, std::span<glm::vec2> out) const;

    /// Computes the fractions (lobe, cosine) of one block of VisibilityBlocks.
    void filter_block(const LaneMirror& mirror, const std::int16_t* block,
                      std::array<Lanes, 2>& fractions) const;

    /// Returns the three tables, one after another, for glsl/high_order_fraction.comp.
    [[nodiscard]] std::vector<float> constants() const;

private:
    int order_;
    std::vector<float> lobe_;        // gain of the lobe by l
    std::vector<float> cosine_;      // gain of the cosine times Y_l0 at -z, by l
    std::vector<float> recurrence_;  // two factors each, [m][l - m]
};

}  // namespace nicol
