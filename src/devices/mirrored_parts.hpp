// SPDX-License-Identifier: MIT
// Mirrored surroundings of a pixel's parts, for textures that perturb normals more finely than the pixel.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

#include "shading/pixel_places.hpp"

namespace nicol {

/// Returns the parts of a pixel. sight: unit direction from the viewer to the shown point. normal: its unit
/// shading normal. normals: those of the parts, row by row. pixel: what the pixel sees without the texture's
/// changes; becomes the pixel with the mean and the second moments of what its parts see.
[[nodiscard]] MirroredParts mirrored_parts(const glm::vec3& sight, const glm::vec3& normal,
                                           std::span<const glm::vec3, MirroredParts::kCount> normals,
                                           MirroredPixel& pixel);

}  // namespace nicol
