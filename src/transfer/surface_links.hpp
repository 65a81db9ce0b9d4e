// SPDX-License-Identifier: MIT
// Links from receivers of bounced light to the surfaces that hide the environment from them.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "transfer/surface_points.hpp"
#include "visibility/bake.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// A blocked direction of a receiver, and the point of a surface's front that blocks it.
struct SurfaceLink {
    std::uint32_t receiver;
    std::uint32_t direction;  ///< index in the DirectionSet
    std::uint32_t triangle;   ///< triangle of the point
    float b1, b2;             ///< barycentric weights of its corners 1 and 2; corner 0 has the rest
    float solid_angle;        ///< solid angle of the blocked directions that the link stands for
    /// Solid angle that the link stands for where coarse links serve alone; 0: the link is not coarse.
    float coarse_solid_angle;
};

/// Number of strata of directions over the sphere, each with one coarse link at most.
inline constexpr std::size_t kLinkStrata = 128;
/// Number of parts of a stratum, each with one link at most.
inline constexpr std::size_t kPartsOfStratum = 4;

/// Search for the links of vertices. Immutable; threads share it.
class LinkSearch {
public:
    /// `geometry`: that of the visibility. The arguments must outlive the object.
    LinkSearch(const BakeGeometry& geometry, const TriangleSides& sides, const DirectionSet& directions,
               const Visibility& visibility);
    ~LinkSearch();
    LinkSearch(const LinkSearch&) = delete;
    LinkSearch& operator=(const LinkSearch&) = delete;

    [[nodiscard]] const DirectionSet& directions() const noexcept { return directions_; }
    /// Unit normals of all vertices.
    [[nodiscard]] std::span<const glm::vec3> normals() const noexcept { return normals_; }

    /// Sets links to the coarse ones of a vertex; their `receiver` is 0. The sphere of directions has
    /// kLinkStrata strata; a vertex has one coarse link for each stratum with blocked directions, in one of
    /// them that is chosen as if by chance. A ray that meets the back of a one-sided surface meets nothing
    /// that leaves light, so it has no link. Returns the harmonic mean of the links' lengths; 0: there is no
    /// link.
    float find(std::size_t vertex, std::vector<SurfaceLink>& links) const;
    /// Adds the other links of a vertex to the coarse ones that find() has set: one for each part of a
    /// stratum with blocked directions but no coarse link.
    void refine(std::size_t vertex, std::vector<SurfaceLink>& links) const;

private:
    /// Sets blocked to the blocked directions first <= d < last of a vertex. Returns their solid angle.
    float find_blocked(std::size_t vertex, std::size_t first, std::size_t last,
                       std::vector<std::uint32_t>& blocked) const;
    /// Adds a link with its end. Returns its length; 0: nothing leaves light there, and no link is added.
    float add(std::size_t vertex, SurfaceLink link, std::vector<SurfaceLink>& links) const;

    const DirectionSet& directions_;
    const Visibility& visibility_;
    std::size_t stratum_size_;  // directions of a stratum
    std::vector<glm::vec3> normals_;
    std::vector<glm::vec3> origins_;
    std::unique_ptr<const SurfacePoints> points_;
};

}  // namespace nicol
