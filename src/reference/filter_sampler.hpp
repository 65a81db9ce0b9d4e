// SPDX-License-Identifier: MIT
// Random places of samples that follow a reconstruction filter.
#pragma once

#include <vector>

#include "image/reconstruction_filter.hpp"

namespace nicol {

/// Sampler of distances from a pixel's centre along one axis, with a density proportional to the filter's
/// absolute value. The mean of weighted samples is the filtered image; weights are 1, up to rounding, of
/// filters without negative lobes.
class FilterSampler {
public:
    explicit FilterSampler(const ReconstructionFilter& filter);

    struct Sample {
        double distance;  ///< in pixels
        double weight;
    };
    /// Returns the sample of a number `u` in [0, 1). Distances lie within [first, last], which contains the
    /// pixel; the filter counts as 0 elsewhere.
    [[nodiscard]] Sample at(double u, double first, double last) const;

private:
    [[nodiscard]] double place(double distance) const;  // in bins, within the table

    ReconstructionFilter filter_;
    double radius_;
    std::vector<double> absolute_;  // integral of the absolute value, up to each bin
    std::vector<double> integral_;  // integral of the filter, up to each bin
};

}  // namespace nicol
