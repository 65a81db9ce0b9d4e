// SPDX-License-Identifier: MIT
// Vertices that other surfaces hide from a camera, or that no sample of an image shows.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "geometry/ray_scene.hpp"
#include "surfaces/geometry.hpp"

namespace nicol {

/// Sets visible[v] to 0 for each vertex of no triangle that an image may show, found by one ray through the
/// centre of each pixel. A triangle may be shown if a ray meets it, or if one of its corners is not behind
/// all that rays meet two pixels around; images whose samples lie elsewhere in their pixels show no others,
/// except through gaps narrower than a pixel. rays: of the geometry; hits have the indices of its triangles.
/// visible: of find_visible(). Runs on the calling thread's TBB arena.
void remove_hidden(const WorldGeometry& geometry, const RayScene& rays, const Projection& projection,
                   std::vector<std::uint8_t>& visible);

/// Sets visible[v] to 0 for each vertex of no triangle that is at a sample of an image, found by one ray
/// through each sample. A sample beside an edge has both triangles there, because images that are drawn round
/// corners to 1/256 of a pixel. Triangles that light passes are shown as remove_hidden() finds them. samples:
/// offsets from the centre of each pixel, in pixels, right and down.
/// geometry: without alpha masks. The rest is that of remove_hidden().
void remove_unsampled(const WorldGeometry& geometry, const RayScene& rays, const Projection& projection,
                      std::span<const glm::dvec2> samples, std::vector<std::uint8_t>& visible);

}  // namespace nicol
