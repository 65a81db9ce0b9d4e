// SPDX-License-Identifier: MIT
// Decoding of JPEG by libjpeg-turbo.
#pragma once

#include <filesystem>
#include <string_view>

#include "image/bitmap.hpp"

namespace nicol {

[[nodiscard]] bool is_jpeg(std::string_view bytes);

/// Reads width, height and channels (1 or 3). Throws Error(invalid_file) that names the file.
void read_jpeg_header(const std::filesystem::path& file, std::string_view bytes, Bitmap& out);
/// Reads the pixels, as Bitmap::codes, of an image with this header. Throws Error(invalid_file) that names
/// the file, also for progressive images of more than 500 scans; Error(unsupported) for large images of fewer
/// scans.
void read_jpeg_pixels(const std::filesystem::path& file, std::string_view bytes, Bitmap& out);

}  // namespace nicol
