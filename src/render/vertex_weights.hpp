// SPDX-License-Identifier: MIT
// Parts that vertices have in predictions of an image.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "surfaces/geometry.hpp"

namespace nicol {

/// Weights of a geometry's vertices, which add up to their number. Half of the weight goes by the area around
/// each vertex: a wall of four vertices covers more pixels than a fine ball behind it. The other half is
/// equal for all vertices: a large floor covers fewer pixels than its area says, and the ball on it more.
class VertexWeights {
public:
    /// baked: as in SurfaceState; samples consist of baked vertices where a material has any.
    explicit VertexWeights(const WorldGeometry& geometry, std::span<const std::uint8_t> baked = {});

    /// Weight of the vertices of one material, and a sample of these vertices in which all count the same.
    struct Group {
        double weight = 0;
        std::vector<std::uint32_t> sample;
    };
    [[nodiscard]] const std::map<MaterialPtr, Group>& groups() const noexcept { return groups_; }

private:
    std::map<MaterialPtr, Group> groups_;
};

}  // namespace nicol
