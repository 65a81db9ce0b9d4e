// SPDX-License-Identifier: MIT
// The value of a pixel and how uncertain it is.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "polarization/stokes.hpp"

namespace nicol {

/// The mean of a pixel's samples, and an estimate of its variance over seeds, for each channel.
///
/// The samples are one stratified set, whose mean varies less than that of independent samples; their own
/// scatter tells nothing of that. So consecutive samples form groups, which are stratified sets of fewer
/// points each, and the scatter of the groups' means is measured: with n_g of n samples and the mean m_g in
/// each of G groups, the variance of the mean m is estimated as sum_g n_g (m_g - m)^2 / ((G - 1) n). In the
/// mean this is the variance of independent samples, and too much where all samples together are stratified
/// better than groups are: v(n / G) - v(n) over G - 1, v(n) being the variance of n samples. Groups of
/// independent points would make it exact and the pixel noisier.
class PixelEstimate {
public:
    static constexpr int kGroups = 4;

    PixelEstimate(int samples, int channels);

    [[nodiscard]] int groups() const noexcept { return groups_; }
    /// The first sample of a group; of groups(): the number of samples.
    [[nodiscard]] int first(int group) const;
    /// `sum`, for each channel, of all samples up to the end of `group`.
    void record(int group, std::span<const Stokes> sum);

    /// These need all groups.
    [[nodiscard]] Stokes mean(int channel) const;
    /// Of each Stokes component of mean(); of 2 samples or more.
    [[nodiscard]] Stokes variance(int channel) const;

private:
    [[nodiscard]] const Stokes& sum_before(int group, int channel) const;

    int samples_;
    int channels_;
    int groups_;
    std::vector<Stokes> sums_;  // [group][channel] of the samples before it, groups() being the last
};

}  // namespace nicol
