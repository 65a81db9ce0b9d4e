// SPDX-License-Identifier: MIT
// Noise of sixteen sums of samples, estimated from the difference between two halves of the samples.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "simd/lanes.hpp"

namespace nicol {

/// Share of SampleHalves::noise() of samples that are spread evenly; measured: 0.3 to 0.5, because each half
/// fills the gaps of the other.
inline constexpr float kShareOfHalves = 0.4F;

/// Observes sums of Stokes vectors, [channel][component], while the samples of one light are added.
class SampleHalves {
public:
    using Sums = std::span<std::array<Lanes, 4>>;

    /// Begins before the first sample. factors: of the squared errors; empty: 1. Keeps references. One object
    /// of a thread at a time.
    SampleHalves(Sums sums, std::span<const float> factors) : sums_(sums), factors_(factors) {
        before_.assign(sums.begin(), sums.end());
    }

    /// Ends the first half of the samples.
    void end_first() { between_.assign(sums_.begin(), sums_.end()); }
    /// Multiplies what the samples so far added by a factor, and makes them the first half.
    void end_first(float factor);

    /// Returns the sum over the first `points` sums of the expected squared error of s0 times their
    /// factors, after the second half. weights: of the first half, whose results are weighted means. shares:
    /// of the error that independent halves would have.
    [[nodiscard]] double noise(std::size_t points, const Lanes& weights, const Lanes& shares) const;
    /// Returns the sum over the first `points` sums of factor times share times the square of the s0
    /// that was added.
    [[nodiscard]] double squares(std::size_t points, const Lanes& shares) const;

private:
    [[nodiscard]] double factor(std::size_t point) const {
        return factors_.empty() ? 1.0 : double{factors_[point]};
    }

    Sums sums_;
    std::span<const float> factors_;
    // Kept by the thread, so that frames allocate no memory.
    static thread_local std::vector<std::array<Lanes, 4>> before_, between_;
};

}  // namespace nicol
