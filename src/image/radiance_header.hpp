// SPDX-License-Identifier: MIT
// Factors in the header of a Radiance HDR file.
#pragma once

#include <array>
#include <filesystem>
#include <string_view>

namespace nicol {

/// Factors of R, G and B that programs have multiplied the pixels by: the product of all lines EXPOSURE= and
/// COLORCORR=, which stand before the first empty line. Radiance is the pixel divided by them. Throws
/// Error(invalid_file) naming the line if one is not a finite number above 0.
[[nodiscard]] std::array<double, 3> radiance_factors(const std::filesystem::path& file,
                                                     std::string_view bytes);

}  // namespace nicol
