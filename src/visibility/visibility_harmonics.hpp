// SPDX-License-Identifier: MIT
// Visibility as spherical harmonics in the vertex's own frame.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "simd/lanes.hpp"
#include "visibility/horizon.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// Converts bits into coefficients over real harmonics, [psh_index(l, m)], of the PROPAGATION direction of
/// the light, as its own coefficients are, in theta_phi_frame(normal). The quadrature is corrected so that
/// what is seen nowhere is 0 and what is seen everywhere above the horizon is exact: sqrt(4 pi), 0, 0 ... for
/// `mirrored`, the half sphere for `dark`.
class VisibilityHarmonics {
public:
    /// Keeps a reference to `directions`. Throws Error(invalid_argument) for an order outside
    /// 0..kHighestOrder.
    VisibilityHarmonics(const DirectionSet& directions, int order, HorizonExtension extension);

    static constexpr int kHighestOrder = 64;

    [[nodiscard]] int order() const noexcept { return order_; }
    [[nodiscard]] HorizonExtension extension() const noexcept { return extension_; }

    /// Coefficients of what sees all above the horizon, by psh_index.
    [[nodiscard]] std::span<const float> everything() const noexcept { return everything_; }
    /// psh_count(order) coefficients of one vertex. Calls may run side by side.
    void project(const Visibility& visibility, std::size_t vertex, const glm::vec3& normal,
                 std::span<float> out) const;

private:
    const DirectionSet& directions_;
    int order_;
    HorizonExtension extension_;
    std::vector<float> everything_;
    std::vector<Lanes> weights_;  // of the directions, in bundles
    std::vector<float> climb_;    // the recursion's two factors for each (l, m)
    std::vector<float> leap_;     // and the three of the one over even l + m
};

}  // namespace nicol
