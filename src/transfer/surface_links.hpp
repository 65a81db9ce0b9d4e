// SPDX-License-Identifier: MIT
// Links from vertices to the surfaces that hide the environment from them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "visibility/bake.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// A blocked direction of a vertex, and the point of a surface's front that blocks it.
struct SurfaceLink {
    std::uint32_t vertex;
    std::uint32_t direction;  ///< index in the DirectionSet
    std::uint32_t triangle;   ///< triangle of the point
    float b1, b2;             ///< barycentric weights of its corners 1 and 2; corner 0 has the rest
    float solid_angle;        ///< solid angle of the blocked directions that the link stands for
};

/// Triangles of a geometry by the side that they show.
struct TriangleSides {
    std::vector<std::uint32_t> fronts;  ///< one-sided triangles and the fronts of two-sided surfaces
    std::vector<std::uint32_t> backs;   ///< the backs of two-sided surfaces
};

/// Number of strata of directions over the sphere.
inline constexpr std::size_t kLinkStrata = 128;

/// Returns the links of all vertices, in the order of the vertices. The sphere of directions has kLinkStrata
/// strata; a vertex has one link for each stratum with blocked directions, in one of them that is chosen as
/// if by chance. A ray that meets the back of a one-sided surface meets nothing that leaves light, so it has
/// no link. `geometry`: that of the visibility. Runs on the calling thread's TBB arena.
[[nodiscard]] std::vector<SurfaceLink> find_links(const BakeGeometry& geometry, const TriangleSides& sides,
                                                  const DirectionSet& directions,
                                                  const Visibility& visibility,
                                                  const BakeProgress& progress = {});

}  // namespace nicol
