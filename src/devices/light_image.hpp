// SPDX-License-Identifier: MIT
// Image of local lights alone, by threads, for an image whose other light is shaded elsewhere.
#pragma once

#include <cstddef>
#include <glm/vec4.hpp>
#include <vector>

#include "methods/executor.hpp"

namespace nicol {

/// Sets out[c][i - first] to channel c of the light that pixel first <= i < last shows of local lights and
/// emissive surfaces: the mean over the pixel's samples. The input's hits must be on the host. Adds rays and
/// time to the statistics.
void find_light_image(const PixelInput& input, std::size_t first, std::size_t last, RenderRun& run,
                      std::vector<std::vector<glm::vec4>>& out);

}  // namespace nicol
