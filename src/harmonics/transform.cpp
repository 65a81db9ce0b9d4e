// SPDX-License-Identifier: MIT
// Transform by a Fourier step and a Legendre step.
#include "harmonics/transform.hpp"

#include <utility>

#include "harmonics/require.hpp"

namespace nicol {

PshTransform::PshTransform(int order, LatitudeRows rows, int columns, double phi0)
    : legendre_(order, std::move(rows)),
      fourier_(order, columns, phi0),
      work_(order, legendre_.rows().count()) {}

void PshTransform::analyze(std::span<const double> samples, std::span<double> coefficients) {
    const auto stride = 4 * static_cast<std::size_t>(columns());
    require_size(samples.size(), stride * static_cast<std::size_t>(work_.rows), "samples");
    fourier_.analyze(samples, work_, 0);
    legendre_.analyze(work_, coefficients);
}

void PshTransform::synthesize(std::span<const double> coefficients, std::span<double> samples) {
    const auto stride = 4 * static_cast<std::size_t>(columns());
    require_size(samples.size(), stride * static_cast<std::size_t>(work_.rows), "samples");
    legendre_.synthesize(coefficients, work_);
    fourier_.synthesize(work_, 0, samples);
}

}  // namespace nicol
