// SPDX-License-Identifier: MIT
// The rows of a material's layers, added up before light is dotted with them.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "material/layer_weights.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// What one layer has at sixteen points. Points refer to rows of a table, and to those `step` further.
struct MixtureRow {
    std::array<const float*, kLanes> rows;  ///< of the first channel
    std::size_t step;
    std::size_t channel_step;     ///< to the rows of the next channel; 0: all channels share the first one's
    std::size_t size;             ///< a row's numbers from here on are 0 or not asked for
    const LayerWeights* weights;  ///< not 0 at some point

    [[nodiscard]] bool alike() const { return channel_step == 0 && weights->equal; }
};

/// Sums of rows times weights, sixteen points side by side. Holds results; one object a thread.
class MixtureRows {
public:
    /// Begins sums of `size` numbers for each channel, of no layers yet.
    void begin(std::size_t size, std::size_t channels);
    /// Keeps a reference to the weights until the next begin().
    void add(const MixtureRow& layer);
    /// After all add(): the numbers from the position `first` on of every channel's sum, of rows interpolated
    /// by `fraction` towards those a step further.
    void sum(const Lanes& fraction, std::size_t first, std::size_t count);

    [[nodiscard]] bool empty() const noexcept { return layers_.empty(); }
    /// Whether those of all channels are equal.
    [[nodiscard]] bool alike() const noexcept { return alike_; }
    [[nodiscard]] const Lanes* of(std::size_t channel) const {
        return sums_.data() + (alike_ ? 0 : channel * size_);
    }

private:
    std::size_t size_ = 0;
    std::size_t channels_ = 0;
    bool alike_ = true;
    bool shared_ = true;  // rows are the same for all channels
    std::vector<MixtureRow> layers_;
    std::vector<Lanes> sums_;  // [channel]
};

}  // namespace nicol
