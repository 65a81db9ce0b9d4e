// SPDX-License-Identifier: MIT
// A scene's vertices after bake, and which of them have not changed since an earlier state.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "surfaces/geometry.hpp"
#include "versioned.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// Versions of all that a vertex's light depends on except the light itself.
struct SurfaceVersions {
    Version geometry = 0;    ///< of vertices and triangles
    Version visibility = 0;  ///< 0: nothing casts shadows
    bool operator==(const SurfaceVersions&) const = default;
};

/// What vertices have in common with those of an earlier state. Both spans have a number for each vertex of
/// the state now: 1 for vertices that then had under the same number ...
struct SurfaceChange {
    SurfaceVersions before;
    std::span<const std::uint8_t> same_field;   ///< ... the same normal and visibility
    std::span<const std::uint8_t> same_places;  ///< ... the same place
};

struct SurfaceState {
    const WorldGeometry& geometry;
    const Visibility* visibility;    ///< of the vertices; null where nothing casts shadows
    const DirectionSet* directions;  ///< of the visibility
    SurfaceVersions versions;
    Version materials;  ///< of the geometry's ranges and their materials
    std::optional<SurfaceChange> change;
};

}  // namespace nicol
