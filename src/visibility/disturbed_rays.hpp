// SPDX-License-Identifier: MIT
// Rays of a bake that added or removed objects may meet.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "geometry/ball.hpp"
#include "geometry/box.hpp"
#include "visibility/visibility_directions.hpp"

namespace nicol {

/// Objects that were added to a scene or removed from it. A moved object counts as both.
struct Disturbances {
    std::span<const Ball> added;    ///< balls that together contain all added triangles
    std::span<const Ball> removed;  ///< balls that together contain all removed triangles
    /// Boxes of the objects in the balls, for points inside a ball; empty: they are not known.
    std::span<const Box> added_boxes = {}, removed_boxes = {};
};

/// Rays from one point, by bundle; bit i is that of the bundle's ray i.
struct DisturbedBundles {
    std::vector<std::uint16_t> may_close;  ///< rays that an added object may block
    std::vector<std::uint16_t> may_open;   ///< rays that a removed object may have blocked
};

/// Finds the rays from a point, in the directions of a bake, that disturbances may affect.
class DisturbedRays {
public:
    /// directions: must outlive the object.
    DisturbedRays(const DirectionSet& directions, const Disturbances& disturbances);
    ~DisturbedRays();
    DisturbedRays(const DisturbedRays&) = delete;
    DisturbedRays& operator=(const DisturbedRays&) = delete;

    /// Sets `bundles`. For directions above the plane of the unit normal the result is conservative: it may
    /// contain too many rays, never too few. Returns whether it contains any. Calls may run side by side.
    bool find(const glm::vec3& origin, const glm::vec3& normal, DisturbedBundles& bundles) const;

private:
    class Finder;
    struct Node;
    std::unique_ptr<const Finder> finder_;
    std::vector<Node> added_, removed_;  // trees of balls
    std::vector<Box> added_boxes_, removed_boxes_;
};

}  // namespace nicol
