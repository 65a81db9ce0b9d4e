// SPDX-License-Identifier: MIT
// Rays of a bake that some triangle may block.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "visibility/bake.hpp"
#include "visibility/bake_rays.hpp"
#include "visibility/ray_cones.hpp"
#include "visibility/vertex_rays.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// Tree of a geometry's triangles, glass included, that finds the rays from a point which no triangle can
/// block: those of points with nothing above their horizon, and those that pass beside everything above it.
class PossibleBlockers {
public:
    /// directions: must outlive the object. find: whether to find such rays at all.
    PossibleBlockers(const BakeGeometry& geometry, const DirectionSet& directions, bool find);

    /// Has the result of trace_vertex() in the scene of the same triangles. Calls may run side by side.
    RayCounts trace(const BakeRays& scene, const glm::vec3& origin, const glm::vec3& normal,
                    std::size_t vertex, const std::optional<FormerBits>& former,
                    Visibility& visibility) const;

    /// Returns the geometry's large flat faces.
    [[nodiscard]] const FlatBlockers& flat() const noexcept { return flat_; }
    /// Returns the cones around the bundles of the directions.
    [[nodiscard]] const RayCones& cones() const noexcept { return cones_; }

private:
    // Triangles in a ball, and between two planes across their mean normal. The first node is the root.
    struct Node {
        glm::dvec3 centre;
        double radius = 0;
        glm::dvec3 axis;  // unit
        // Lowest and highest corner along the axis, from the centre.
        double lowest = 0;
        double highest = 0;
        // Distance to the node of the second half of the triangles; the nodes of the first half lie between.
        // 0: a leaf.
        std::uint32_t right = 0;
        std::uint32_t first = 0, last = 0;  // corners of a leaf
    };

    // Appends the subtree of some triangles, whose order it changes. first: place of their corners.
    void build(std::span<glm::uvec3> triangles, std::size_t first, int depth, std::vector<Node>& nodes);
    // Moves the triangles of a node's first half to the front, and returns their number.
    std::size_t divide(std::span<glm::uvec3> triangles, int depth) const;
    [[nodiscard]] Node bound(std::span<const glm::uvec3> triangles) const;
    // Returns whether a point of the node may lie above the horizon of rays.
    [[nodiscard]] bool above(const Node& node, const glm::dvec3& origin, const glm::dvec3& normal) const;
    // Sets the bits of the rays that may be blocked, if `faces` are the cones to all flat faces. Returns
    // false if most of them may be.
    bool find(const glm::vec3& origin, const glm::vec3& normal, std::span<const FlatBlockers::Cone> faces,
              std::vector<std::uint16_t>& bits) const;

    const DirectionSet& directions_;
    const bool finds_;
    FlatBlockers flat_;
    RayCones cones_;
    std::vector<glm::dvec3> positions_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> corners_;  // of leaves: numbers of positions
};

/// Returns geometry.possible_blockers(), or a new tree where that is empty or none is to be found.
[[nodiscard]] std::shared_ptr<const PossibleBlockers> possible_blockers_of(const BakeGeometry& geometry,
                                                                           const DirectionSet& directions,
                                                                           bool find);

}  // namespace nicol
