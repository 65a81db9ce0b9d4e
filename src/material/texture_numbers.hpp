// SPDX-License-Identifier: MIT
// Numbers between which a material whose number varies by a texture is interpolated.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "texture/texture.hpp"

namespace nicol {

/// Returns numbers from the least to the largest value of a texture's first channel, clamped to least..1 with
/// least above 0, ascending. They are its values if these are up to 16 (or up to `most`). Otherwise
/// interpolation between neighbours, whose error grows as the square of the logarithm of their ratio, is as
/// good as between numbers of this ratio: in the mean over the texture, and to 3 times the error anywhere
/// that the texture has values. most: number of numbers that are returned at most; 2 or more.
[[nodiscard]] std::vector<double> texture_numbers(const Texture& texture, double least, double ratio,
                                                  std::optional<std::size_t> most = {});

}  // namespace nicol
