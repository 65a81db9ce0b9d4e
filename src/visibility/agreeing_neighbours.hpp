// SPDX-License-Identifier: MIT
// Rays of a bake whose result is known from vertices around.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "visibility/bake.hpp"
#include "visibility/disturbed_rays.hpp"
#include "visibility/vertex_rays.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// Part of a sample of rays in which points of one pixel may differ, because no image shows it.
inline constexpr double kWrongInPixel = 1.0 / 32;

/// Bits and unit normal of a point.
struct Seeing {
    std::span<const std::uint64_t> bits;
    glm::vec3 normal;
};

/// Rays of a point on which points around it agree, and a sample of these rays that is to confirm them.
struct Agreement {
    std::vector<std::uint64_t> bits;     ///< of the point, where those around agree
    std::vector<std::uint64_t> checked;  ///< 1 for the sample
    DisturbedBundles traced;             ///< the sample, and the rays on which the points disagree
    std::uint64_t sampled = 0;           ///< number of rays of the sample
    std::uint64_t spared = 0;            ///< number of other rays above the horizon

    /// Finds the agreement of points, of which `fewest`, 1 to 3, must have a direction above their horizon.
    /// normal and number: of the point in the middle.
    void find(std::span<const Seeing> around, std::size_t fewest, const DirectionSet& directions,
              const glm::vec3& normal, std::size_t number);
    /// Traces `traced` and, unless that confirms the rest, all other rays. wrong: part of the sample that may
    /// differ from what the points around see. row: bits
    /// of the point, 0 before. trace: sets a row whose bits are 0, from what it is told is known, and returns
    /// the numbers of rays.
    template <class Trace>
    RayCounts settle(double wrong, std::span<std::uint64_t> row, const Trace& trace) {
        const FormerBits known{.bits = bits, .disturbed = &traced};
        RayCounts counts = trace(known);
        if (confirmed(row, wrong)) {
            counts.skipped += spared;
            return counts;
        }
        ask_rest(row);
        std::ranges::fill(row, 0U);
        const RayCounts rest = trace(known);
        return {.traced = counts.traced + rest.traced, .skipped = counts.skipped + rest.skipped};
    }

private:
    // Returns whether the sample, once traced, is as the points around see it, but for a part of at most
    // `wrong`.
    [[nodiscard]] bool confirmed(std::span<const std::uint64_t> traced_bits, double wrong) const;
    // Makes `bits` the result of tracing, and `traced` all other rays.
    void ask_rest(std::span<const std::uint64_t> traced_bits);
};

/// Vertices of fine surfaces in the order in which a bake traces them: first a few far apart, then by turns
/// those between, whose rays are traced only in directions in which the vertices around see different things,
/// and a sample of the others. If one of these differs from what the vertices around see, all are traced:
/// the surface has details between its vertices, or something touches it. Vertices in pixels of others come
/// last, and take what these see, see BakeGeometry::like.
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
