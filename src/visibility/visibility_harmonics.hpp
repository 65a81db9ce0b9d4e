// SPDX-License-Identifier: MIT
// Visibility as spherical harmonics in each vertex's own frame.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "simd/lanes.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// Projection of visibility bits to coefficients over real harmonics, [psh_index(l, m)]. Harmonics are
/// functions of the PROPAGATION direction of the light, like the light's own coefficients, in
/// theta_phi_frame(normal). Below the horizon, where nothing reflects, visibility is mirrored: V(x, y, -z) =
/// V(x, y, z). Therefore there is no step at the horizon, and coefficients of odd l + m are zero. The
/// quadrature is corrected so that a fully occluded vertex has 0 and an unoccluded one has exactly sqrt(4
/// pi), 0, 0 ...
class VisibilityHarmonics {
public:
    /// Keeps a reference to `directions`. Throws Error(invalid_argument) for an order outside
    /// 0..kHighestOrder.
    VisibilityHarmonics(const DirectionSet& directions, int order);

    static constexpr int kHighestOrder = 64;
    /// First coefficient of an unoccluded vertex, sqrt(4 pi); its other coefficients are 0.
    static constexpr float kUnoccluded = 3.5449077F;

    [[nodiscard]] int order() const noexcept { return order_; }

    /// Computes the psh_count(order) coefficients of one vertex. Calls may run side by side.
    void project(const Visibility& visibility, std::size_t vertex, const glm::vec3& normal,
                 std::span<float> out) const;

private:
    const DirectionSet& directions_;
    int order_;
    std::vector<Lanes> weights_;     // weights of the directions, in bundles
    std::vector<float> recurrence_;  // three factors for each (l, m)
};

}  // namespace nicol
