// SPDX-License-Identifier: MIT
// Weights of a material that is one layer.
#pragma once

#include <array>

#include "devices/pixel_batch.hpp"
#include "material/layer_weights.hpp"

namespace nicol {

/// Weight of the only layer.
inline constexpr LayerWeights kWholeLayer = [] {
    LayerWeights out{.value = {}, .points = 0xFFFF, .equal = true};
    for (Lanes& of_color : out.value) of_color.value.fill(1);
    return out;
}();

/// Weights of the only layer at the points of a batch, [block of sixteen].
inline constexpr std::array<LayerWeights, PixelBatch::kMost / kLanes> kWholeLayers = [] {
    std::array<LayerWeights, PixelBatch::kMost / kLanes> out{};
    out.fill(kWholeLayer);
    return out;
}();

}  // namespace nicol
