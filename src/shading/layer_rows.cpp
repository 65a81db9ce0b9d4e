// SPDX-License-Identifier: MIT
#include "shading/layer_rows.hpp"

#include <algorithm>

namespace nicol {
namespace {

// Returns the rows of one layer at the views of a block.
MixtureRow row_of(const ResponseTable& response, const LaneView::TablePositions& at, std::size_t numbers,
                  const LayerWeights& weights) {
    const std::size_t channel_step = response.rows(0, 0).size();
    MixtureRow out{.rows = {},
                   .step = channel_step * static_cast<std::size_t>(response.channels()),
                   .channel_step = response.channels() == 1 ? 0 : channel_step,
                   .size = numbers,
                   .weights = &weights};
    for (std::size_t i = 0; i < kLanes; ++i) out.rows[i] = response.rows(at.angle[i], 0).data();
    return out;
}

}  // namespace

std::size_t components_of(const ResponseTable& response, const ComponentLimits& limits) {
    const std::size_t made = response.makes(3) ? 4 : response.makes(1) || response.makes(2) ? 3 : 1;
    return std::clamp(made, limits.least, limits.most);
}

std::size_t sum_layers(std::span<const ResponseTable* const> layers, std::span<const LayerWeights> weights,
                       const LaneView::TablePositions& at, std::size_t pairings, std::size_t channels,
                       const ComponentLimits& limits, MixtureRows& rows) {
    std::size_t made = 0, row_size = 0;
    for (std::size_t l = 0; l < layers.size(); ++l) {
        if (layers[l]->pairings() != pairings || weights[l].points == 0) continue;
        row_size = layers[l]->row_size();
        if (made == 0) rows.begin(4 * row_size, channels);
        const std::size_t own = components_of(*layers[l], limits);
        made = std::max(made, own);
        rows.add(row_of(*layers[l], at, own * row_size, weights[l]));
    }
    // The count is rounded up because whole squares are faster to transpose.
    if (made > 0) rows.sum(at.fraction, 0, std::max(made * row_size, std::min(kLanes, 4 * row_size)));
    return made;
}

}  // namespace nicol
