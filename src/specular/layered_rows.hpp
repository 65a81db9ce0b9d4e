// SPDX-License-Identifier: MIT
// The rows of a material's layers, added up before light is dotted with them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "material/layer_weights.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// Sums of rows of numbers, sixteen vertices side by side, times weights: what layers have in common for all
/// channels once, the rest by channel. Holds results; one object a thread.
class LayeredRows {
public:
    /// Begins sums of `size` numbers for each channel.
    void begin(std::size_t size, std::size_t channels);
    /// Adds `count` numbers, from the position `first` on, that serve all channels.
    void add(const LayerWeights& weights, const Lanes* row, std::size_t count, std::size_t first);
    /// Adds those of one channel.
    void add(const LayerWeights& weights, std::size_t channel, const Lanes* row, std::size_t count,
             std::size_t first);
    /// Completes the sums.
    void end();

    [[nodiscard]] bool empty() const noexcept { return !common_ && !own_; }
    /// Whether those of all channels are equal.
    [[nodiscard]] bool alike() const noexcept { return !own_; }
    [[nodiscard]] const Lanes* of(std::size_t channel) const { return sums_.data() + place(channel); }

private:
    [[nodiscard]] std::size_t place(std::size_t channel) const { return own_ ? (channel + 1) * size_ : 0; }
    void begin_own();

    std::size_t size_ = 0;
    std::size_t channels_ = 0;
    bool common_ = false;      // there is anything in common
    bool own_ = false;         // there is anything by channel
    std::vector<Lanes> sums_;  // in common, then of each channel
};

}  // namespace nicol
