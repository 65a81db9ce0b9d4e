// SPDX-License-Identifier: MIT
// Local lights alone at pixels, on threads, for an image whose other light is shaded elsewhere.
#pragma once

#include <cstddef>
#include <glm/vec4.hpp>
#include <vector>

#include "methods/executor.hpp"

namespace nicol {

/// out[c][i - first] becomes what pixel first <= i < last shows of local lights and of emissive surfaces in
/// channel c: the mean over its samples. The input's hits are on the host. Adds to the statistics.
void find_light_image(const PixelInput& input, std::size_t first, std::size_t last, RenderRun& run,
                      std::vector<std::vector<glm::vec4>>& out);

}  // namespace nicol
