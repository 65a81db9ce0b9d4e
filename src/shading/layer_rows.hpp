// SPDX-License-Identifier: MIT
// Rows of a material's layers at sixteen views.
#pragma once

#include <cstddef>
#include <span>

#include "material/layer_weights.hpp"
#include "material/response_table.hpp"
#include "shading/lane_view.hpp"
#include "specular/mixture_rows.hpp"

namespace nicol {

/// Limits of the number of leading Stokes components that are computed: 1, 3 or 4.
struct ComponentLimits {
    std::size_t least = 1;
    std::size_t most = 4;
};

/// Returns the number of leading components that a material reflects, within the limits.
[[nodiscard]] std::size_t components_of(const ResponseTable& response, const ComponentLimits& limits);

/// Sums the rows of the layers with this number of pairings, times their weights. at: the views in tables of
/// ResponseTable::kAngles angles. Returns the number of components of the sum; 0: no layer has these
/// pairings.
[[nodiscard]] std::size_t sum_layers(std::span<const ResponseTable* const> layers,
                                     std::span<const LayerWeights> weights,
                                     const LaneView::TablePositions& at, std::size_t pairings,
                                     std::size_t channels, const ComponentLimits& limits, MixtureRows& rows);

}  // namespace nicol
