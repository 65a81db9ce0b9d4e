// SPDX-License-Identifier: MIT
// bake: more vertices where shadows change faster than a mesh is fine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "visibility/bake.hpp"

namespace nicol {

struct RefineOptions {
    /// Largest error that interpolation along an edge may make in what is hidden: the irradiance of a white
    /// environment and its first moment, relative to the irradiance without shadows. Above 0.
    double tolerance = 0.02;
    /// That there may be in the end; nothing is refined where there are as many already.
    std::size_t max_vertices = 65536;
};

/// A mesh with some of its triangles replaced by smaller ones, and what its vertices see. Whatever a vertex
/// carries follows from `parents`, in order: an added vertex has the mean of the two.
struct Refinement {
    std::vector<glm::uvec2> parents;     ///< of added vertices, which are numbered after those given
    std::vector<glm::uvec3> triangles;   ///< all
    std::vector<std::uint32_t> sources;  ///< the given triangle that each is a part of; not decreasing
    Visibility visibility;               ///< of given and added vertices
};

/// Splits triangles of a baked geometry until what is hidden from vertices is linear between them to the
/// tolerance, edges with the largest error times squared length first. The surface stays where it is.
///
/// Where blocked rays land close to their start, triangles are first made about as small as that is close or
/// as the triangles around the start: what stands on the middle of a large triangle hides nothing from its
/// corners. Shadows may jump: edges shorter than 1/32 of the shadowed region's extent may err by more, in
/// inverse proportion, and those shorter than 1/256 are not split.
///
/// `visibility` is bake()'s; added vertices are traced as its are. Where nothing is occluded nothing is done,
/// and `parents` is empty. Adds its rays, vertices and time to `statistics`. The result depends on the
/// arguments alone. Throws what bake() throws.
[[nodiscard]] Refinement refine(const BakeGeometry& geometry, const DirectionSet& directions,
                                const Visibility& visibility, const RefineOptions& options,
                                const BakeProgress& progress, BakeStatistics& statistics);

}  // namespace nicol
