// SPDX-License-Identifier: MIT
// Visibility as spherical harmonics in each vertex's own frame.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "harmonics/lane_rotation.hpp"
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
    /// Keeps a reference to `directions`. Runs on all threads of the caller's arena. Throws
    /// Error(invalid_argument) for an order outside 0..kHighestOrder.
    VisibilityHarmonics(const DirectionSet& directions, int order);

    static constexpr int kHighestOrder = 64;
    /// First coefficient of an unoccluded vertex, sqrt(4 pi); its other coefficients are 0.
    static constexpr float kUnoccluded = 3.5449077F;
    /// Number of vertices that share the work on directions. Calls for more vertices are no faster, calls for
    /// fewer are slower.
    static constexpr std::size_t kBatch = 128;

    [[nodiscard]] int order() const noexcept { return order_; }
    [[nodiscard]] const DirectionSet& directions() const noexcept { return directions_; }

    /// Computes the psh_count(order) coefficients of each vertex: out[block of sixteen][psh_index], a vertex
    /// in each lane. The last block's other lanes repeat the last vertex. normals: of all vertices, unit.
    /// Calls may run side by side.
    void project(const Visibility& visibility, std::span<const glm::vec3> normals,
                 std::span<const std::uint32_t> vertices, std::span<Lanes> out) const;

private:
    // At most kBatch vertices.
    void project_batch(const Visibility& visibility, std::span<const glm::vec3> normals,
                       std::span<const std::uint32_t> vertices, std::span<Lanes> out) const;

    const DirectionSet& directions_;
    int order_;
    LaneRotation rotation_;
    std::vector<Lanes> weights_;  // weights of the directions, in bundles
    std::size_t row_ = 0;         // numbers of a row
    std::vector<Lanes> rows_;     // weight times the harmonics, row_ numbers of each direction
};

}  // namespace nicol
