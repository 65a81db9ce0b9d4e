// SPDX-License-Identifier: MIT
// Small bright parts of an image.
#pragma once

#include <vector>

#include "light/environment.hpp"

namespace nicol {

struct LampPixels {
    struct Pixel {
        int row, column;
    };
    std::vector<Pixel> pixels;
    /// What is taken out of them: Stokes vectors, [pixel][channel][p], physical where the image is. It leaves
    /// unpolarized light, as bright as what is around the lamp or all that a pixel has.
    std::vector<float> values;
};

/// At most `most` lamps, those first of which harmonics would miss most: parts within 0.5 rad and 0.2 sr that
/// are brighter than four times the mean, unless all that orders 10 to 32 have of them is little.
[[nodiscard]] std::vector<LampPixels> find_lamps(const EquirectView& view, int most);

}  // namespace nicol
