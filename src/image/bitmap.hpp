// SPDX-License-Identifier: MIT
// Images as people have them: PNG, JPEG, BMP, TGA and Radiance HDR.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "files/load_budget.hpp"
#include "image/stokes_image.hpp"

namespace nicol {

struct Bitmap {
    int width = 0;
    int height = 0;
    int channels = 0;           ///< 1 (grey), 2 (with alpha), 3 (R G B) or 4 (with alpha)
    bool linear = false;        ///< radiance; else numbers of 0 to 1, of which colours are sRGB-encoded
    std::vector<float> values;  ///< [y][x][channel], row 0 at the top
};

/// Whether the suffix is one of a bitmap: .png, .jpg, .jpeg, .bmp, .tga, .hdr or .rgbe, in any case.
[[nodiscard]] bool is_bitmap(const std::filesystem::path& file);

/// Reads a file by its content (TGA, which has no mark, by its suffix): 8 and 16 bits, palettes, run
/// lengths, progressive JPEG, exposure and colour correction of Radiance. Throws Error(file_not_found);
/// Error(unsupported) for another format or more than kMaxImageSide or kMaxImagePixels; Error(invalid_file)
/// where it is empty, damaged or truncated. Takes the memory of its values from `budget` before it decodes,
/// and no more of compressed pixels than the image holds is inflated.
[[nodiscard]] Bitmap read_bitmap(const std::filesystem::path& file, const LoadBudget& budget = {});
/// The same of the bytes of a file with this name, which is not opened.
[[nodiscard]] Bitmap read_bitmap(const std::filesystem::path& file, std::string_view bytes,
                                 const LoadBudget& budget = {});

/// Its colours as unpolarized light, one channel where it is grey; alpha is not used.
[[nodiscard]] StokesImage unpolarized_image(const Bitmap& bitmap);

}  // namespace nicol
