// SPDX-License-Identifier: MIT
// bake: the directions in which the environment is visible from each vertex.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <span>

#include "geometry/ray_scene.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// All surfaces of the world, which cast shadows and receive them. A surface with two sides appears twice,
/// the second time with normals and winding reversed.
struct BakeGeometry {
    std::span<const glm::vec3> positions;
    std::span<const glm::vec3> normals;  ///< of vertices; any length but zero
    std::span<const glm::uvec3> triangles;
    Presence present = {};  ///< empty: triangles are whole
    /// The triangles' ray hierarchy, asked for where rays are traced; empty: bake() and refine() build their
    /// own.
    std::function<std::shared_ptr<const RayScene>()> rays = {};
};

/// Returns geometry.rays(), or a new hierarchy where that is empty.
[[nodiscard]] std::shared_ptr<const RayScene> rays_of(const BakeGeometry& geometry);

struct BakeStatistics {
    std::uint64_t rays = 0;
    std::uint64_t vertices = 0;     ///< that any rays were traced from
    double milliseconds = 0;        ///< of tracing
    double build_milliseconds = 0;  ///< of the hierarchy of boxes
    std::uint64_t unoccluded = 0;   ///< vertices
    bool from_cache = false;        ///< nothing was traced
};

/// Vertices first .. last - 1 of a list; in an earlier list they began at `before`.
struct VertexRun {
    std::size_t first;
    std::size_t last;
    std::size_t before;
};

/// A sphere and what is inside.
struct Ball {
    glm::vec3 centre;
    float radius;
};

/// A bake in the same directions of the surfaces before some of them were added, removed or moved.
struct FormerBake {
    const Visibility& visibility;
    std::span<const VertexRun> kept;     ///< vertices that have not moved
    std::span<const Ball> disturbances;  ///< all added and removed triangles lie inside, wholly
};

/// Receives the fraction done, 0 to 1, on the calling thread, several times a second. What it throws, such as
/// Error(cancelled), stops the bake and reaches the caller.
using BakeProgress = std::function<void(double fraction)>;

/// Traces one ray from each vertex in each direction above its horizon. Triangles block from both sides. Rays
/// start beside their vertex, by 2^-19 of the largest coordinate around it along the normal and as much away
/// from the edges of its own triangles: no convex surface shadows itself, whatever its size, as long as
/// normals lie between those of the faces around their vertex, and no light comes through the walls of a
/// corner.
///
/// With a former bake only those rays are traced whose result may differ from before; the result is the same.
///
/// Runs on all threads of the calling thread's TBB arena; the result does not depend on their number. Throws
/// Error(invalid_argument) where a normal is zero or not finite, counts differ, a position is not finite or
/// beyond 1e15 or an index out of range; Error(out_of_memory).
[[nodiscard]] Visibility bake(const BakeGeometry& geometry, const DirectionSet& directions,
                              const BakeProgress& progress = {}, BakeStatistics* statistics = nullptr,
                              const FormerBake* former = nullptr);

}  // namespace nicol
