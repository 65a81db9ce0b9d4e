// SPDX-License-Identifier: MIT
#include "reference/pixel_estimate.hpp"

#include <algorithm>
#include <cstdint>

namespace nicol {

PixelEstimate::PixelEstimate(int samples, int channels)
    : samples_(samples),
      channels_(channels),
      groups_(std::min(kGroups, samples)),
      sums_(static_cast<std::size_t>(groups_ + 1) * static_cast<std::size_t>(channels), Stokes(0.0)) {}

int PixelEstimate::first(int group) const {
    return static_cast<int>(std::int64_t{samples_} * group / groups_);
}

void PixelEstimate::record(int group, std::span<const Stokes> sum) {
    std::ranges::copy(sum, sums_.begin() + std::ptrdiff_t{group + 1} * channels_);
}

Stokes PixelEstimate::mean(int channel) const {
    return sum_before(groups_, channel) / static_cast<double>(samples_);
}

Stokes PixelEstimate::variance(int channel) const {
    const Stokes whole = mean(channel);
    Stokes scatter(0.0);
    for (int g = 0; g < groups_; ++g) {
        const double count = first(g + 1) - first(g);
        const Stokes off = (sum_before(g + 1, channel) - sum_before(g, channel)) / count - whole;
        scatter += count * off * off;
    }
    return scatter / (static_cast<double>(groups_ - 1) * samples_);
}

const Stokes& PixelEstimate::sum_before(int group, int channel) const {
    return sums_[static_cast<std::size_t>(group * channels_ + channel)];
}

}  // namespace nicol
