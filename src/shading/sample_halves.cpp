// SPDX-License-Identifier: MIT
#include "shading/sample_halves.hpp"

#include <algorithm>

namespace nicol {

thread_local std::vector<std::array<Lanes, 4>> SampleHalves::before_;
thread_local std::vector<std::array<Lanes, 4>> SampleHalves::between_;

void SampleHalves::end_first(float factor) {
    for (std::size_t c = 0; c < sums_.size(); ++c)
        for (std::size_t p = 0; p < 4; ++p)
            for (std::size_t i = 0; i < kLanes; ++i)
                sums_[c][p][i] = before_[c][p][i] + factor * (sums_[c][p][i] - before_[c][p][i]);
    end_first();
}

double SampleHalves::noise(std::size_t points, const Lanes& weights, const Lanes& shares) const {
    constexpr float least_weight = 1e-3F;
    // Both halves estimate the same. If they were independent, the variance of the whole would be the square
    // of their difference times both weights.
    Lanes squares{};
    for (std::size_t c = 0; c < sums_.size(); ++c) {
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float before = before_[c][0][i], between = between_[c][0][i], after = sums_[c][0][i];
            const float first = weights[i], second = 1 - first;
            const float difference = (between - before) * second - (after - between) * first;
            squares[i] += difference * difference / std::max(first * second, least_weight);
        }
    }
    double noise = 0;
    for (std::size_t i = 0; i < points; ++i) noise += factor(i) * double{shares[i]} * double{squares[i]};
    return noise;
}

double SampleHalves::squares(std::size_t points, const Lanes& shares) const {
    double sum = 0;
    for (std::size_t c = 0; c < sums_.size(); ++c) {
        for (std::size_t i = 0; i < points; ++i) {
            const double added = double{sums_[c][0][i]} - double{before_[c][0][i]};
            sum += factor(i) * double{shares[i]} * added * added;
        }
    }
    return sum;
}

}  // namespace nicol
