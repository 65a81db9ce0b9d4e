// SPDX-License-Identifier: MIT
// The visible fractions of the lobes through which vertices reflect light to a viewer.
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

/// Visible fractions for HighOrder.
class HighOrderVisibility {
public:
    /// order: of the visibility. width: of the lobe about the mirror direction, radians, as for
    /// gaussian_gains(); where the order cannot resolve it, it is widened. Throws Error(invalid_argument) for
    /// an order out of 0..64 or a width that is not in 0..4.
    HighOrderVisibility(int order, double width);

    /// For first <= v < last with visible[v] != 0, writes to out[v] the visible fractions, 0..1, of a lobe
    /// about the mirrored view direction and of the cosine about the normal; both are 1 at unoccluded
    /// vertices. `seen` has the order of this object. Calls for different vertices may run side by side.
    void run(const Viewpoint& view, std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
             std::span<const std::uint8_t> visible, const VisibilityBlocks& seen, std::size_t first,
             std::size_t last, std::span<glm::vec2> out) const;

    /// The same fractions, lobe and cosine, of one block of VisibilityBlocks.
    void filter_block(const LaneMirror& mirror, const std::int16_t* block,
                      std::array<Lanes, 2>& fractions) const;

    /// For glsl/high_order_fraction.comp: three tables, one after another.
    [[nodiscard]] std::vector<float> constants() const;

private:
    int order_;
    std::vector<float> lobe_;        // by l, gain
    std::vector<float> cosine_;      // by l, gain times Y_l0 at -z
    std::vector<float> recurrence_;  // [m][l - m], two factors each
};

}  // namespace nicol
