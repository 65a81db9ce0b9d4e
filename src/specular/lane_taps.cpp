// SPDX-License-Identifier: MIT
#include "specular/lane_taps.hpp"

#include <algorithm>
#include <cmath>

#include "simd/work_space.hpp"
#include "specular/lane_lobe.hpp"

namespace nicol {
namespace {

// Returns a direction rotated by an angle towards another, orthogonal one.
LaneVectors rotated(const LaneVectors& from, const LaneVectors& towards, float cosine, float sine) {
    LaneVectors out;
    for (std::size_t i = 0; i < kLanes; ++i) {
        out.x[i] = cosine * from.x[i] + sine * towards.x[i];
        out.y[i] = cosine * from.y[i] + sine * towards.y[i];
        out.z[i] = cosine * from.z[i] + sine * towards.z[i];
    }
    return out;
}

}  // namespace

LaneTaps::LaneTaps(const HighOrderMaps& maps, double spread, bool base)
    : maps_(maps),
      outer_(spread > 0),
      base_(base),
      cosine_(static_cast<float>(std::cos(spread))),
      sine_(static_cast<float>(std::sin(spread))) {
    const std::size_t numbers = 4 * static_cast<std::size_t>(maps.central->layers());
    const std::span<Lanes> all = work_space<LaneTaps, Lanes>(6 * numbers);
    std::ranges::fill(all, Lanes{});
    std::size_t begin = 0;
    for (std::span<Lanes>* some : {&at_central_, &up_, &down_, &right_, &left_, &at_base_}) {
        *some = all.subspan(begin, numbers);
        begin += numbers;
    }
}

void LaneTaps::sample(const LaneMirror& mirror) {
    const LaneVectors& d = mirror.d;
    const LaneVectors& x = mirror.x;
    sample_lobe(*maps_.central, d, x, at_central_.data());
    if (outer_) {
        const LobeMap& map = *maps_.outer;
        sample_lobe(map, rotated(d, mirror.y, cosine_, sine_), x, up_.data());
        sample_lobe(map, rotated(d, mirror.y, cosine_, -sine_), x, down_.data());
        sample_lobe(map, rotated(d, x, cosine_, sine_), rotated(x, d, cosine_, -sine_), right_.data());
        sample_lobe(map, rotated(d, x, cosine_, -sine_), rotated(x, d, cosine_, sine_), left_.data());
    }
    if (base_) sample_lobe(*maps_.base, mirror.inward, x, at_base_.data());
}

ChannelTaps LaneTaps::channel(std::size_t channel) const {
    const std::size_t components = maps_.central->polarized() ? 4 : 1;
    const std::size_t own = maps_.central->channels() == 1 ? 0 : channel * components;
    return {.central = &at_central_[own],
            .up = outer_ ? &up_[own] : nullptr,
            .down = &down_[own],
            .right = &right_[own],
            .left = &left_[own],
            .base = base_ ? &at_base_[own] : nullptr};
}

}  // namespace nicol
