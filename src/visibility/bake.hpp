// SPDX-License-Identifier: MIT
// The bake step: visibility of the environment at each vertex, found by tracing rays.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <span>

#include "geometry/ray_scene.hpp"
#include "visibility/bake_rays.hpp"
#include "visibility/disturbed_rays.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

class PossibleBlockers;

/// All surfaces of the world; each casts and receives shadows. A two-sided surface appears twice, the second
/// time with normals and winding reversed.
struct BakeGeometry {
    std::span<const glm::vec3> positions;
    std::span<const glm::vec3> normals;  ///< normals of the vertices, of any length but zero
    std::span<const glm::uvec3> triangles;
    Presence present = {};  ///< alpha mask; empty: triangles are whole
    /// Triangles as rays meet them: those that light passes have no area. Empty: all block rays.
    std::span<const glm::uvec3> blocking = {};
    std::shared_ptr<const BakeGlass> glass = {};  ///< glass that dims light; null: none
    /// The triangles' ray hierarchy, asked for where rays are traced; empty: bake() and refine() build their
    /// own.
    std::function<std::shared_ptr<const RayScene>()> rays = {};
    /// The triangles' PossibleBlockers for the same directions, asked for where rays are spared; empty:
    /// bake() and refine() build their own.
    std::function<std::shared_ptr<const PossibleBlockers>()> possible_blockers = {};
    /// 1 for each vertex whose visibility is needed. Other vertices are not traced, and triangles at them are
    /// not refined. They count as unoccluded, or keep the bits of a former bake. Empty: all vertices.
    std::span<const std::uint8_t> needed = {};
    bool needed_alone = false;  ///< whether bake() leaves the bits of other vertices at 0
    /// For each vertex, a needed one in the same pixel of an image that faces about the same way, whose
    /// visibility it takes but for a sample of rays; kNoVertex: none. Empty: none for all.
    std::span<const std::uint32_t> like = {};
    bool every_ray = false;  ///< whether rays whose result is known without are traced as well

    /// Vertices beyond the geometry's, which refinement adds, are needed.
    [[nodiscard]] bool needs(std::size_t vertex) const {
        return vertex >= needed.size() || needed[vertex] != 0;
    }
    /// Returns the vertex in the same pixel; kNoVertex: none.
    [[nodiscard]] std::uint32_t like_of(std::size_t vertex) const {
        return vertex < like.size() && !every_ray ? like[vertex] : kNoVertex;
    }
};

/// Returns geometry.rays(), or a new hierarchy where that is empty, and the glass.
[[nodiscard]] BakeRays rays_of(const BakeGeometry& geometry);

struct BakeStatistics {
    std::uint64_t rays = 0;
    std::uint64_t rays_skipped = 0;  ///< number of rays whose result was known without
    std::uint64_t vertices = 0;      ///< number of vertices with rays, traced or skipped
    double milliseconds = 0;         ///< time of tracing
    double build_milliseconds = 0;   ///< time of building the bounding volume hierarchy
    std::uint64_t unoccluded = 0;    ///< number of unoccluded vertices
    bool from_cache = false;         ///< whether the result was read from a file and nothing was traced
};

/// Vertices first .. last - 1 of a list; `before` is the place of `first` in an earlier list.
struct VertexRun {
    std::size_t first;
    std::size_t last;
    std::size_t before;
};

/// Object that was shifted since an earlier state, and did not change otherwise.
struct ShiftedObject {
    VertexRun vertices;
    glm::dvec3 shift{0};
    /// All other objects: where they are, and where they were, as seen from the object.
    Disturbances others;
};

/// Scene that the bits of a vertex of an earlier bake belong to.
enum class Known : std::uint8_t {
    nothing,  ///< no scene: the vertex was not baked
    former,   ///< the scene of that bake
    earlier   ///< a scene before it; the bits of shifted objects count as not baked then
};

/// Result of an earlier bake in the same directions, and the surfaces that were added, removed or moved
/// since.
struct FormerBake {
    const Visibility& visibility;
    std::span<const VertexRun> kept;  ///< runs of vertices that have not moved
    Disturbances disturbances;
    std::span<const ShiftedObject> shifted = {};
    /// State of each vertex of `visibility`. Empty: all are known.
    std::span<const Known> known = {};
    Disturbances earlier = {};  ///< disturbances since the state that Known::earlier belongs to
};

/// Receives the fraction done, 0 to 1, on the calling thread, several times a second. An exception that it
/// throws, such as Error(cancelled), stops the bake and reaches the caller.
using BakeProgress = std::function<void(double fraction)>;

/// Traces one ray from each vertex in each direction above its horizon. Triangles block rays from both sides.
/// Rays start beside their vertex: 2^-19 of the largest coordinate around it along the normal, and as far
/// from the edges of the vertex's own triangles. Therefore no convex surface shadows itself, whatever its
/// size, if normals lie between those of the faces around their vertex; and no light comes through the walls
/// of a corner.
///
/// If a former bake is given, only rays whose result may differ are traced. Rays that large flat faces
/// certainly block are spared, see FlatBlockers. Rays of new vertices, unless these are few, are also spared
/// if nothing can block them or vertices around agree, see AgreeingNeighbours.
///
/// Runs on all threads of the calling thread's TBB arena; the result does not depend on their number. Throws
/// Error(invalid_argument) if a normal is zero or not finite, counts differ, a position is not finite or
/// beyond 1e15, or an index is out of range; throws Error(out_of_memory).
[[nodiscard]] Visibility bake(const BakeGeometry& geometry, const DirectionSet& directions,
                              const BakeProgress& progress = {}, BakeStatistics* statistics = nullptr,
                              const FormerBake* former = nullptr);

}  // namespace nicol
