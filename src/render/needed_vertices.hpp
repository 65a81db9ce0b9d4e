// SPDX-License-Identifier: MIT
// Vertices whose visibility an image needs.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "surfaces/geometry.hpp"
#include "surfaces/surface_rays.hpp"

namespace nicol {

struct NeededVertices {
    /// 1 for each vertex whose visibility is needed, else 0. Empty: all are needed.
    std::vector<std::uint8_t> flags;
    /// 1 for each vertex of a triangle that can be seen and reflects light, else 0.
    std::vector<std::uint8_t> seen;
    double pixel = 0;      ///< side of a pixel at the nearest vertex that is seen; 0 if none is
    bool sampled = false;  ///< whether vertices were spared that no sample shows
};

/// Vertices and shadows that images need.
enum class ImageNeeds : std::uint8_t {
    seen,  ///< the vertices that they show: needed_vertices(). If they show smooth surfaces, which may show
           ///< any vertex: all vertices, and shadows as fine as pixels, but none nearer than what is seen
    all    ///< all vertices, and shadows of any detail
};

/// Returns whether a material reflects any light.
[[nodiscard]] bool reflects(const Material& material);

/// Returns what the images of some views need for direct light: vertices of triangles that can be seen and
/// reflect light, and a sample of the other vertices of each instance, whose shadows say where triangles are
/// refined. All flags are 0 if no triangle is seen that reflects light. `flags` is empty if so few vertices
/// can be spared that all are needed. rays: of the geometry, which rays from pixels use if they spare more
/// than they cost. The sample does not depend on the views. samples: offsets from the centre of each pixel of
/// all samples at which the images show surfaces; empty: not known. known: not 0 for each vertex that costs
/// little to bake, because it was baked before some change; empty: for none. The sample leaves these out.
/// Runs on the calling thread's TBB arena.
[[nodiscard]] NeededVertices needed_vertices(const WorldGeometry& geometry, std::span<const Projection> views,
                                             std::span<const glm::dvec2> samples, SurfaceRays& rays,
                                             std::span<const std::uint8_t> known = {});

/// Returns, for each needed vertex, the first one in the same pixel that faces about the same way, or
/// kNoVertex if that is the vertex itself; kNoVertex for the others. Empty if few vertices have another one.
/// flags: as NeededVertices::flags. pixel: its side.
[[nodiscard]] std::vector<std::uint32_t> vertices_in_pixels(const WorldGeometry& geometry,
                                                            std::span<const std::uint8_t> flags,
                                                            double pixel);

/// Returns whether two sets of images, each of one sample per pixel or more, need the same vertices because
/// their views differ by no more than a pixel's side, as those of jittered cameras do.
[[nodiscard]] bool need_the_same(std::span<const Projection> a, std::span<const Projection> b);

/// Returns whether two sets of images have the same views, to the last bit.
[[nodiscard]] bool are_equal(std::span<const Projection> a, std::span<const Projection> b);

/// Returns whether rays go on from a surface that an image shows, so that the image needs vertices which it
/// does not show. shown: by vertex, whether the image shows it. lobes: whether rays follow lobes, see
/// follows_lobes().
[[nodiscard]] bool shows_others(const WorldGeometry& geometry, std::span<const std::uint8_t> shown,
                                bool lobes);

}  // namespace nicol
