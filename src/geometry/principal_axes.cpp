// SPDX-License-Identifier: MIT
#include "geometry/principal_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace nicol {
namespace {

// Smallest relative difference of two variances, and smallest relative third moment, that define an axis.
constexpr double kDistinct = 1e-3;

// Returns the orthonormal eigenvectors of a symmetric matrix as columns, in the order of decreasing
// eigenvalues. Jacobi's method: each rotation makes one off-diagonal element vanish.
glm::dmat3 eigenvectors(glm::dmat3 a) {
    glm::dmat3 vectors(1.0);
    constexpr int sweeps = 20;  // convergence is quadratic
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (const auto& [p, q] : {std::array{0, 1}, std::array{0, 2}, std::array{1, 2}}) {
            if (a[p][q] == 0) continue;
            const double angle = std::atan2(2 * a[p][q], a[p][p] - a[q][q]) / 2;
            glm::dmat3 rotation(1.0);
            rotation[p][p] = rotation[q][q] = std::cos(angle);
            rotation[p][q] = std::sin(angle);
            rotation[q][p] = -rotation[p][q];
            a = glm::transpose(rotation) * a * rotation;
            vectors = vectors * rotation;
        }
    }
    std::array<int, 3> order{0, 1, 2};
    std::ranges::stable_sort(order, std::greater(), [&a](int i) { return a[i][i]; });
    return {vectors[order[0]], vectors[order[1]], vectors[order[2]]};
}

}  // namespace

glm::dmat3 principal_axes(std::span<const glm::vec3> points) {
    glm::dvec3 low(std::numeric_limits<double>::max());
    glm::dvec3 high(std::numeric_limits<double>::lowest());
    glm::dvec3 centre(0.0);
    for (const glm::vec3& point : points) {
        low = glm::min(low, glm::dvec3(point));
        high = glm::max(high, glm::dvec3(point));
        centre += glm::dvec3(point) / static_cast<double>(points.size());
    }
    const double size = points.empty() ? 0 : glm::length(high - low);
    if (!(size > 0)) return glm::dmat3(1);

    // Points are divided by the size, so that nothing overflows or underflows.
    glm::dmat3 covariance(0.0);
    for (const glm::vec3& point : points) {
        const glm::dvec3 d = (glm::dvec3(point) - centre) / size;
        covariance += glm::outerProduct(d, d) / static_cast<double>(points.size());
    }
    glm::dmat3 axes = eigenvectors(covariance);
    // Rounding would decide the axes of nearly equal variances.
    glm::dvec3 variance;
    for (int i = 0; i < 3; ++i) variance[i] = glm::dot(axes[i], covariance * axes[i]);
    if (variance[0] - variance[1] < kDistinct * variance[0] ||
        variance[1] - variance[2] < kDistinct * variance[1]) {
        return glm::dmat3(1);
    }
    for (int i = 0; i < 2; ++i) {
        double third = 0;
        for (const glm::vec3& point : points) {
            const double along = glm::dot((glm::dvec3(point) - centre) / size, axes[i]);
            third += along * along * along / static_cast<double>(points.size());
        }
        if (std::abs(third) < kDistinct * std::pow(variance[i], 1.5)) return glm::dmat3(1);
        axes[i] = glm::normalize(third < 0 ? -axes[i] : axes[i]);
    }
    axes[1] = glm::normalize(axes[1] - glm::dot(axes[1], axes[0]) * axes[0]);
    axes[2] = glm::cross(axes[0], axes[1]);
    return axes;
}

}  // namespace nicol
