// SPDX-License-Identifier: MIT
// Value of a pixel and its uncertainty.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "polarization/stokes.hpp"

namespace nicol {

/// Mean of a pixel's samples, and an estimate of the mean's variance over seeds, for each channel.
///
/// The samples are one stratified set, whose mean varies less than that of independent samples. The scatter
/// of single samples does not show this. Therefore consecutive samples form groups, which are stratified sets
/// of fewer points each, and the scatter of the groups' means is measured. With n_g of n samples and the mean
/// m_g in each of G groups, the variance of the mean m is estimated as sum_g n_g (m_g - m)^2 / ((G - 1) n).
/// The estimate's expectation is (v(n / G) - v(n)) / (G - 1), v(n) being the variance of n samples. The
/// expectation equals v(n) for independent samples, and exceeds v(n) if all samples together are stratified
/// better than groups are. Groups of independent points would make the estimate exact and the pixel noisier.
class PixelEstimate {
public:
    static constexpr int kGroups = 4;

    PixelEstimate(int samples, int channels);

    [[nodiscard]] int groups() const noexcept { return groups_; }
    /// Returns the first sample of a group; for group == groups(), the number of samples.
    [[nodiscard]] int first(int group) const;
    /// Records a group. sum: for each channel, the sum of all samples up to the end of `group`.
    void record(int group, std::span<const Stokes> sum);

    /// Returns the mean of all samples. All groups must be recorded.
    [[nodiscard]] Stokes mean(int channel) const;
    /// Returns the variance of each Stokes component of mean(). There must be 2 samples or more, and all
    /// groups must be recorded.
    [[nodiscard]] Stokes variance(int channel) const;

private:
    [[nodiscard]] const Stokes& sum_before(int group, int channel) const;

    int samples_;
    int channels_;
    int groups_;
    std::vector<Stokes> sums_;  // sums of the samples before each group, [group up to groups()][channel]
};

}  // namespace nicol
