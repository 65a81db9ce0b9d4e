// SPDX-License-Identifier: MIT
// Light coefficients in the layout of tables and vertices.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "polarization/stokes.hpp"

namespace nicol::test {

/// Returns the numbers of one channel's coefficients in the layout's order. `channel` is [psh_index(l,
/// m)][4].
inline std::vector<double> light_coefficients(const LightLayout& layout, std::span<const double> channel) {
    std::vector<double> out;
    for (const auto& [first, second] : layout.terms())
        out.push_back(first.factor * channel[first.coefficient] +
                      second.factor * channel[second.coefficient]);
    return out;
}

/// Returns even + i odd for each pair of a row. A part that m = 0 lacks is 0.
inline std::vector<std::complex<double>> light_pairs(const LightLayout& layout,
                                                     std::span<const double> channel) {
    const std::vector<double> numbers = light_coefficients(layout, channel);
    std::vector<std::complex<double>> out;
    for (const LightLayout::Run& run : layout.runs()) {
        for (std::size_t i = 0; i < run.count; ++i) {
            const bool both = run.even != run.odd;
            out.emplace_back(both || run.sign > 0 ? numbers[run.even + i] : 0,
                             both || run.sign < 0 ? numbers[run.odd + i] : 0);
        }
    }
    return out;
}

/// Multiplies rows [p][pairing][j] of a response with light in pairs. The result is the Stokes vector for a
/// viewer at azimuth 0.
template <class Number>
Stokes rows_times_light(std::span<const Number> rows, const std::vector<std::complex<double>>& pairs) {
    const std::size_t pairings = rows.size() / (4 * pairs.size());
    Stokes out(0.0);
    for (std::size_t row = 0; row < 4 * pairings; ++row) {
        const bool even = (row / pairings < 2) == (row % pairings == 0);
        for (std::size_t j = 0; j < pairs.size(); ++j)
            out[static_cast<int>(row / pairings)] += static_cast<double>(rows[row * pairs.size() + j]) *
                                                     (even ? pairs[j].real() : pairs[j].imag());
    }
    return out;
}

}  // namespace nicol::test
