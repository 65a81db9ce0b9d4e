// SPDX-License-Identifier: MIT
// Images in common formats: PNG, JPEG, BMP, TGA and Radiance HDR.
#pragma once

#include <cstdint>
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
    bool linear = false;        ///< radiance; else values of 0 to 1 with sRGB-encoded colours
    std::vector<float> values;  ///< [y][x][channel], row 0 at the top
    /// The numbers n of values n / 255, which `values` then leaves out; see BitmapValues::codes.
    std::vector<std::uint8_t> codes{};
};

/// Form of the values of images of 8 bits.
enum class BitmapValues : std::uint8_t {
    floats,
    codes  ///< codes of the file, in a quarter of the memory
};

/// Returns whether the suffix is one of a bitmap: .png, .jpg, .jpeg, .bmp, .tga, .hdr or .rgbe, in any case.
[[nodiscard]] bool is_bitmap(const std::filesystem::path& file);

/// Reads a file by its content (TGA, which has no signature, by its suffix): 8 and 16 bits, palettes, run
/// lengths, progressive JPEG, exposure and colour correction of Radiance. Throws Error(file_not_found);
/// Error(unsupported) for another format or an image beyond kMaxImageSide or kMaxImagePixels;
/// Error(invalid_file) if the file is empty, damaged or truncated. Takes the memory of the values from
/// `budget` before decoding, and inflates no more compressed pixels than the image holds.
[[nodiscard]] Bitmap read_bitmap(const std::filesystem::path& file, const LoadBudget& budget = {},
                                 BitmapValues values = BitmapValues::floats);
/// Decodes the bytes of a file. `file` is their name and is not opened.
[[nodiscard]] Bitmap read_bitmap(const std::filesystem::path& file, std::string_view bytes,
                                 const LoadBudget& budget = {}, BitmapValues values = BitmapValues::floats);

/// Returns the bitmap's colours as unpolarized light, in one channel if the bitmap is grey. Alpha is not
/// used.
[[nodiscard]] StokesImage unpolarized_image(const Bitmap& bitmap);

}  // namespace nicol
