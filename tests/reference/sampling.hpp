// SPDX-License-Identifier: MIT
// Statistics of densities over the sphere.
#pragma once

#include <cmath>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <random>
#include <vector>

namespace nicol::test {

using Density = std::function<double(const glm::dvec3& direction)>;
using Sampler = std::function<glm::dvec3(const glm::dvec2& point)>;

inline constexpr int theta_bins = 40;
inline constexpr int phi_bins = 80;

/// Returns the integrals over the bins of a grid in the zenith angle (about +z) and the azimuth, by
/// midpoints.
inline std::vector<double> integrals(const Density& density, int sub = 12) {
    const double theta_step = std::numbers::pi / (theta_bins * sub);
    const double phi_step = 2 * std::numbers::pi / (phi_bins * sub);
    std::vector<double> bins(std::size_t{theta_bins} * phi_bins);
    for (int i = 0; i < theta_bins * sub; ++i) {
        const double theta = (i + 0.5) * theta_step;
        for (int j = 0; j < phi_bins * sub; ++j) {
            const double phi = (j + 0.5) * phi_step;
            const glm::dvec3 d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                               std::cos(theta));
            bins[static_cast<std::size_t>(i / sub * phi_bins + j / sub)] +=
                density(d) * std::sin(theta) * theta_step * phi_step;
        }
    }
    return bins;
}

inline double sum(const std::vector<double>& values) {
    double total = 0;
    for (const double v : values) total += v;
    return total;
}

/// Returns the number of standard deviations by which the chi-square statistic of samples exceeds its
/// expectation. Bins with few expected samples are merged into one.
inline double chi_square_excess(const Sampler& sampler, const std::vector<double>& expected, int count,
                                unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform;
    std::vector<double> observed(expected.size());
    for (int i = 0; i < count; ++i) {
        const double x = uniform(random);
        const glm::dvec3 d = sampler({x, uniform(random)});
        const double theta = std::atan2(std::hypot(d.x, d.y), d.z);
        const double phi = std::atan2(d.y, d.x);
        const int row = std::min(static_cast<int>(theta / std::numbers::pi * theta_bins), theta_bins - 1);
        const double share = phi / (2 * std::numbers::pi);
        const int column =
            std::min(static_cast<int>((share < 0 ? share + 1 : share) * phi_bins), phi_bins - 1);
        ++observed[static_cast<std::size_t>(row * phi_bins + column)];
    }
    double statistic = 0, few_observed = 0, few_expected = 0;
    int freedom = 0;
    const auto add = [&](double seen, double wanted) {
        statistic += (seen - wanted) * (seen - wanted) / wanted;
        ++freedom;
    };
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const double wanted = expected[i] * count;
        if (wanted > 10) {
            add(observed[i], wanted);
        } else {
            few_observed += observed[i];
            few_expected += wanted;
        }
    }
    if (few_expected > 10) {
        add(few_observed, few_expected);
    } else {
        statistic += few_observed > few_expected + 40 ? 1e9 : 0;
    }
    return (statistic - freedom) / std::sqrt(2.0 * freedom);
}

}  // namespace nicol::test
