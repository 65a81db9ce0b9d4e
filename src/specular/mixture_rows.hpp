// SPDX-License-Identifier: MIT
// Weighted sum of the rows of a material's layers, computed before the dot product with light.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "material/layer_weights.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// Rows of one layer at sixteen points. Each point refers to a row of a table and to the row `step` further.
struct MixtureRow {
    std::array<const float*, kLanes> rows;  ///< rows of the first channel
    std::size_t step;
    std::size_t channel_step;     ///< step to the rows of the next channel; 0: all channels share one row
    std::size_t size;             ///< count of numbers; a row's numbers from here on are 0 or not needed
    const LayerWeights* weights;  ///< weights that are not 0 at all points

    [[nodiscard]] bool alike() const { return channel_step == 0 && weights->equal; }
};

/// Sums of rows times weights, sixteen points side by side. Holds results, so each thread needs its own
/// object.
class MixtureRows {
public:
    /// Starts sums of `size` numbers for each channel, without layers.
    void begin(std::size_t size, std::size_t channels);
    /// Adds a layer; keeps a reference to its weights until the next begin().
    void add(const MixtureRow& layer);
    /// Computes `count` numbers from the position `first` on of every channel's sum, after all add(). Rows
    /// are interpolated by `fraction` towards the rows a step further.
    void sum(const Lanes& fraction, std::size_t first, std::size_t count);

    [[nodiscard]] bool empty() const noexcept { return layers_.empty(); }
    /// Returns whether the sums of all channels are equal.
    [[nodiscard]] bool alike() const noexcept { return alike_; }
    [[nodiscard]] const Lanes* of(std::size_t channel) const {
        return sums_.data() + (alike_ ? 0 : channel * size_);
    }

private:
    std::size_t size_ = 0;
    std::size_t channels_ = 0;
    bool alike_ = true;
    bool shared_ = true;  // whether all channels share their rows
    std::vector<MixtureRow> layers_;
    std::vector<Lanes> sums_;  // [channel]
};

}  // namespace nicol
