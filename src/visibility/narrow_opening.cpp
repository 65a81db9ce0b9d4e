// SPDX-License-Identifier: MIT
#include "visibility/narrow_opening.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "harmonics/psh.hpp"
#include "visibility/visibility_harmonics.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

// Irradiance over pi by even light of radiance 1: the whole correction below the first, none above the
// second.
constexpr double kNarrow = 0.2;
constexpr double kWide = 0.35;

// Limits of the factor, because a truncated irradiance near 0 says nothing.
constexpr double kLeast = 0.1;
constexpr double kMost = 3;

}  // namespace

float narrow_opening_factor(const DirectionSet& directions, const Visibility& visibility, std::size_t vertex,
                            const glm::vec3& normal, std::span<const float> zonal) {
    double all = 0, seen = 0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const double cosine = glm::dot(glm::dvec3(normal), glm::dvec3(directions.directions()[i]));
        if (!(cosine > 0)) continue;
        const double weight = cosine * static_cast<double>(directions.weights()[i]);
        all += weight;
        if (visibility.seen(vertex, i)) seen += weight;
    }
    const double exact = all > 0 ? seen / all : 0;
    if (exact >= kWide) return 1;

    // The integral of P_l(z) z over the upper half: pi, pi / 4, and so on by the ratio of l - 1 and l + 4.
    double truncated = 0, integral = pi;
    for (std::size_t k = 0; k < zonal.size(); ++k) {
        const double l = 2.0 * static_cast<double>(k);
        truncated += static_cast<double>(zonal[k]) * std::sqrt((2 * l + 1) / (4 * pi)) * integral / pi;
        integral *= (1 - l) / (l + 4);
    }
    const double factor = truncated > exact / kMost ? std::clamp(exact / truncated, kLeast, kMost) : kMost;
    const double share = std::clamp((kWide - exact) / (kWide - kNarrow), 0.0, 1.0);
    return static_cast<float>(1 + share * (factor - 1));
}

void scale_narrow_opening(const DirectionSet& directions, const Visibility& visibility, std::size_t vertex,
                          const glm::vec3& normal, int order, std::span<float> coefficients,
                          std::size_t stride) {
    if (visibility.unoccluded(vertex)) return;
    // Directions that are the visible fraction of the hemisphere have at least its square of the irradiance,
    // when they lie along the horizon.
    const float fraction = coefficients.front() / VisibilityHarmonics::kUnoccluded;
    if (fraction * fraction > static_cast<float>(kWide) + 0.01F) return;
    std::vector<float> zonal;
    for (int l = 0; l <= order; l += 2) zonal.push_back(coefficients[stride * psh_index(l, 0)]);
    const float factor = narrow_opening_factor(directions, visibility, vertex, normal, zonal);
    if (factor == 1) return;
    for (std::size_t k = 0; k < coefficients.size(); k += stride) coefficients[k] *= factor;
}

}  // namespace nicol
