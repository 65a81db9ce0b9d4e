// SPDX-License-Identifier: MIT
// Refinement of a mesh at shadows that change faster than its vertices can represent.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "visibility/bake.hpp"
#include "visibility/traced_points.hpp"

namespace nicol {

/// Share of the tracing of given vertices in the progress of a bake that is refined.
inline constexpr double kTracingOfBake = 0.5;

/// Length in pixels of edges that are not split. Shadows are interpolated along them.
inline constexpr double kPixelsOfEdge = 2;

struct RefineOptions {
    /// Largest interpolation error along an edge in the hidden irradiance (of a white environment) and its
    /// first moment, relative to the irradiance without shadows. Stricter where much is hidden: relative to
    /// the irradiance that is left, to a quarter. Above 0.
    double tolerance = 0.02;
    /// Largest number of vertices of the result. Nothing is refined if there are as many already.
    std::size_t max_vertices = 65536;
    /// Length of edges that need no splitting whatever their error, because a picture does not resolve them:
    /// kPixelsOfEdge. Points in one pixel share what they see, but for a sample of rays.
    double shortest_edge = 0;
    /// 1 for each given vertex whose triangles are split, else 0. Empty: all are.
    std::span<const std::uint8_t> wanted = {};
};

/// A mesh with some of its triangles replaced by smaller ones, and the visibility at its vertices. All other
/// vertex attributes follow from `parents`, in order: an added vertex has the mean of its two parents.
struct Refinement {
    std::vector<glm::uvec2> parents;     ///< two parents of each added vertex; added vertices come last
    std::vector<glm::uvec3> triangles;   ///< all triangles of the refined mesh
    std::vector<std::uint32_t> sources;  ///< given triangle that contains each triangle; not decreasing
    Visibility visibility;               ///< visibility at the given and the added vertices
    TracedPoints points = {};            ///< all points that were examined
};

/// An earlier refinement in the same directions, and what has changed since.
struct FormerRefinement {
    const TracedPoints& points;
    Disturbances disturbances;
    std::span<const ShiftedObject> shifted = {};  ///< by their vertices, ascending
};

/// Splits triangles of a baked geometry until the hidden irradiance is linear between vertices within the
/// tolerance, in the order of decreasing error times squared length of edges. The surface itself does not
/// change.
///
/// Triangles near the start of blocked rays are refined first: to about the length of the blocked ray, or to
/// the size of the triangles around its start if that is larger. This step is needed because an object in the
/// middle of a large triangle hides nothing from the triangle's corners. Shadows may be discontinuous.
/// Therefore edges shorter than 1/32 of the shadowed region's extent may err by more, in inverse proportion,
/// and edges shorter than 1/256 are not split.
///
/// `visibility` must be the result of bake(); added vertices are traced in the same way. If no vertex is
/// occluded, nothing is refined and `parents` is empty. Adds its rays, vertices and time to `statistics`.
///
/// If a former refinement is given, only rays whose result may differ are traced; the result equals that
/// without it. Throws what bake() throws.
[[nodiscard]] Refinement refine(const BakeGeometry& geometry, const DirectionSet& directions,
                                const Visibility& visibility, const RefineOptions& options,
                                const BakeProgress& progress, BakeStatistics& statistics,
                                const FormerRefinement* former = nullptr);

/// Returns whether refine() may split anything: a vertex is occluded, and there may be more vertices.
[[nodiscard]] bool can_refine(const Visibility& visibility, const RefineOptions& options);

}  // namespace nicol
