// SPDX-License-Identifier: MIT
// Rays of a bake whose result is known from vertices around.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "visibility/bake.hpp"
#include "visibility/disturbed_rays.hpp"
#include "visibility/ray_cones.hpp"
#include "visibility/vertex_rays.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// Bits and unit normal of a point.
struct Seeing {
    std::span<const std::uint64_t> bits;
    glm::vec3 normal;
};

/// Rays of a point on which points around it agree, and a sample of these rays that is to confirm them.
struct Agreement {
    std::vector<std::uint64_t> bits;     ///< bits of the point, where those around agree
    std::vector<std::uint64_t> checked;  ///< 1 for the sample
    DisturbedBundles traced;             ///< the sample, and the rays on which the points disagree
    std::vector<std::uint16_t> spared;   ///< by bundle, the other rays above the horizon
    std::size_t few = 0;  ///< number of rays of the sample that may differ before all are traced

    /// Finds the agreement of points, of which `fewest`, 1 to 3, must have a direction above their horizon.
    /// normal and number: of the point in the middle.
    void find(std::span<const Seeing> around, std::size_t fewest, const DirectionSet& directions,
              const glm::vec3& normal, std::size_t number);
    /// Traces `traced`, and all spared rays if more than `few` of the sample differ from what the points
    /// around see. If only a few differ, traces the spared rays beside these and so on, because rays that
    /// differ lie beside each other. row: bits of the point, 0 before. cones: of the directions. trace: sets
    /// a row whose bits are 0, from what it is told is known, and returns the numbers of rays.
    template <class Trace>
    RayCounts settle(std::span<std::uint64_t> row, const RayCones& cones, const Trace& trace) {
        const FormerBits known{.bits = bits, .disturbed = &traced};
        RayCounts counts = trace(known);
        for (bool more = find_wrong(row, cones); more; more = find_wrong(row, cones)) {
            std::ranges::fill(row, 0U);
            const RayCounts of_more = trace(known);
            counts.traced += of_more.traced;
            counts.skipped += of_more.skipped;
        }
        for (const std::uint16_t rays : spared)
            counts.skipped += static_cast<std::uint64_t>(std::popcount(rays));
        return counts;
    }

private:
    // Makes `bits` the result of tracing, and `traced` and `checked` the spared rays that may differ too if
    // checked ones do. Returns whether there are any.
    bool find_wrong(std::span<const std::uint64_t> traced_bits, const RayCones& cones);
};

/// Vertices of fine surfaces in the order in which a bake traces them: first a few far apart, then by turns
/// those between, whose rays are traced only in directions in which the vertices around see different things,
/// and a sample of the others. If one of these differs from what the vertices around see, then so may the
/// rays beside it: the surface has details between its vertices, or something touches it. Vertices in pixels
/// of others come last, and take what these see, see BakeGeometry::like.
class AgreeingNeighbours {
public:
    /// geometry and normals, which are of unit length, must outlive the object. find: whether to find such
    /// vertices at all.
    AgreeingNeighbours(const BakeGeometry& geometry, std::span<const glm::vec3> normals, bool find);

    /// Returns the vertices by turn: those of a turn need the results of earlier turns only. Together they
    /// are all that the geometry needs.
    [[nodiscard]] std::span<const std::vector<std::uint32_t>> turns() const noexcept { return turns_; }

    /// Finds what the neighbours of a vertex, which are of earlier turns, agree on, or what the vertex in the
    /// same pixel sees. Returns whether there are enough of them, and one is occluded: where none is, the
    /// search for possible blockers is faster still. Calls may run side by side.
    bool find(std::uint32_t vertex, const DirectionSet& directions, const Visibility& visibility,
              Agreement& out) const;

private:
    void order();
    // Returns whether a vertex is needed, and takes nothing that another sees.
    [[nodiscard]] bool traced(std::uint32_t v) const;
    // Adds a turn of the vertices that do.
    void add_like();
    // Finds the vertices of earlier turns around a vertex that face as it does.
    void find_around(std::uint32_t vertex, std::vector<std::uint32_t>& out) const;

    const BakeGeometry& geometry_;
    std::span<const glm::vec3> normals_;
    std::vector<std::vector<std::uint32_t>> turns_;
    // A point is the first of the vertices at one position; the others there follow as a chain.
    std::vector<std::uint32_t> point_of_, next_;
    // Points of earlier turns around a point p: number first_[p] to first_[p] + count_[p] - 1.
    std::vector<std::size_t> first_;
    std::vector<std::uint8_t> count_;
    std::vector<std::uint32_t> around_;
};

}  // namespace nicol
