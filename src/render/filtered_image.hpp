// SPDX-License-Identifier: MIT
// Image whose pixels are weighted means of samples of the pixels around them.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "image/reconstruction_filter.hpp"
#include "image/stokes_image.hpp"

namespace nicol {

/// Sum of images, each of which has one sample of every pixel at one place. Stokes vectors of neighbouring
/// pixels are added component by component, although the camera's frame field turns slightly from pixel to
/// pixel, as Mitsuba adds them. There are no samples beyond the border; weights are divided by their sum at
/// each pixel.
class FilteredImage {
public:
    FilteredImage(const ReconstructionFilter& filter, int width, int height, int channels);

    /// Adds the samples at `place`, relative to the pixels' centres, right and down, in pixels. Runs on the
    /// threads of the calling thread's TBB arena; the result does not depend on their number.
    void add(const StokesImage& samples, const glm::dvec2& place);
    /// Returns the weighted mean of what was added.
    [[nodiscard]] StokesImage mean() &&;

private:
    ReconstructionFilter filter_;
    StokesImage sum_;
    std::vector<float> weights_;  // by pixel
    std::vector<float> across_;   // samples, filtered along x
};

}  // namespace nicol
