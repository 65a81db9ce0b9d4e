// SPDX-License-Identifier: MIT
// Work space for values of points in several colour channels.
#pragma once

#include <cstddef>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace nicol {

/// Resizes a work space to one value per channel and point, and returns the points' values of each channel.
/// All values of a work space that was empty are 0.
[[nodiscard]] inline std::vector<std::span<glm::vec4>> channel_spans(std::vector<glm::vec4>& values,
                                                                     std::size_t channels,
                                                                     std::size_t points) {
    values.resize(channels * points);
    std::vector<std::span<glm::vec4>> out;
    for (std::size_t c = 0; c < channels; ++c) out.push_back(std::span(values).subspan(c * points, points));
    return out;
}

}  // namespace nicol
