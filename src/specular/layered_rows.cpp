// SPDX-License-Identifier: MIT
#include "specular/layered_rows.hpp"

#include <algorithm>

#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

[[gnu::always_inline]] inline void add_times(const Lanes& weight, const Lanes* row, std::size_t count,
                                             Lanes* sum) {
    LaneVector w;
    load(&weight, w);
    for (std::size_t j = 0; j < count; ++j) {
        LaneVector x;
        load(row + j, x);
        LaneVector s;
        load(sum + j, s);
        store(sum + j, s + w * x);
    }
}

}  // namespace

void LayeredRows::begin(std::size_t size, std::size_t channels) {
    size_ = size;
    channels_ = channels;
    common_ = own_ = false;
    sums_.resize(std::max(sums_.size(), (channels + 1) * size));
}

void LayeredRows::begin_own() {
    if (own_) return;
    own_ = true;
    std::fill_n(sums_.begin() + static_cast<std::ptrdiff_t>(size_), channels_ * size_, Lanes{});
}

void LayeredRows::add(const LayerWeights& weights, const Lanes* row, std::size_t count, std::size_t first) {
    if (!weights.equal && channels_ > 1) {
        for (std::size_t c = 0; c < channels_; ++c) add(weights, c, row, count, first);
        return;
    }
    if (!common_) std::fill_n(sums_.begin(), size_, Lanes{});
    common_ = true;
    dispatch<add_times>(weights.of(0), row, count, sums_.data() + first);
}

void LayeredRows::add(const LayerWeights& weights, std::size_t channel, const Lanes* row, std::size_t count,
                      std::size_t first) {
    begin_own();
    dispatch<add_times>(weights.of(channel), row, count, sums_.data() + place(channel) + first);
}

void LayeredRows::end() {
    if (!common_ || !own_) return;
    static const Lanes one = [] {
        Lanes lanes{};
        lanes.value.fill(1.0F);
        return lanes;
    }();
    for (std::size_t c = 0; c < channels_; ++c)
        dispatch<add_times>(one, sums_.data(), size_, sums_.data() + place(c));
}

}  // namespace nicol
