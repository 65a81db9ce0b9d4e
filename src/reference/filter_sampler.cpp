// SPDX-License-Identifier: MIT
#include "reference/filter_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace nicol {
namespace {

constexpr std::size_t kBins = 2048;

double interpolated(const std::vector<double>& table, double place) {
    const auto bin = std::min(static_cast<std::size_t>(place), kBins - 1);
    return std::lerp(table[bin], table[bin + 1], place - static_cast<double>(bin));
}

}  // namespace

FilterSampler::FilterSampler(const ReconstructionFilter& filter)
    : filter_(filter), radius_(filter.radius()), absolute_{0}, integral_{0} {
    const double width = 2 * radius_ / kBins;
    for (std::size_t i = 0; i < kBins; ++i) {
        const double value = filter_((static_cast<double>(i) + 0.5) * width - radius_);
        absolute_.push_back(absolute_.back() + width * std::abs(value));
        integral_.push_back(integral_.back() + width * value);
    }
}

double FilterSampler::place(double distance) const {
    return std::clamp((distance / radius_ + 1) / 2, 0.0, 1.0) * kBins;
}

FilterSampler::Sample FilterSampler::at(double u, double first, double last) const {
    const double begin = place(first);
    const double end = place(last);
    const double absolute_begin = interpolated(absolute_, begin);
    const double absolute = interpolated(absolute_, end) - absolute_begin;
    const double integral = interpolated(integral_, end) - interpolated(integral_, begin);
    const double wanted = absolute_begin + u * absolute;
    const auto above = std::upper_bound(absolute_.begin(), absolute_.end() - 1, wanted);
    const auto bin = static_cast<std::size_t>(above - absolute_.begin()) - 1;
    const double step = absolute_[bin + 1] - absolute_[bin];
    const double in_bin = std::clamp((wanted - absolute_[bin]) / step, 0.0, 1.0);
    // Bins have the value at their middle, of the sign there.
    const double sign = integral_[bin + 1] < integral_[bin] ? -1 : 1;
    return {.distance = (2 * (static_cast<double>(bin) + in_bin) / kBins - 1) * radius_,
            .weight = sign * absolute / integral};
}

}  // namespace nicol
