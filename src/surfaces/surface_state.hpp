// SPDX-License-Identifier: MIT
// A scene's vertices after bake, and the vertices that have not changed since an earlier state.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "surfaces/geometry.hpp"
#include "versioned.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// Versions of everything that a vertex's light depends on, except the light itself.
struct SurfaceVersions {
    Version geometry = 0;    ///< version of vertices and triangles
    Version visibility = 0;  ///< version of the visibility; 0: nothing casts shadows
    bool operator==(const SurfaceVersions&) const = default;
};

/// Vertices that have not changed since an earlier state. Both spans have one number per vertex of the
/// current state.
struct SurfaceChange {
    SurfaceVersions before;
    /// Index in the earlier state of a vertex with equal visibility, or kNoVertex.
    std::span<const std::uint32_t> former;
    std::span<const std::uint8_t> same_places;  ///< 1: that vertex has an equal position, too
    /// 0: that vertex had another normal, with which its visibility has turned. Empty: all normals are equal.
    std::span<const std::uint8_t> same_normals = {};
};

struct SurfaceState {
    const WorldGeometry& geometry;
    const Visibility* visibility;    ///< visibility of the vertices; null: nothing casts shadows
    const DirectionSet* directions;  ///< directions of the visibility
    SurfaceVersions versions;
    Version materials;  ///< version of the geometry's ranges and their materials
    std::optional<SurfaceChange> change;
    /// Not 0 for each vertex that was baked; others count as unoccluded. Empty: all vertices were.
    std::span<const std::uint8_t> baked = {};
};

}  // namespace nicol
