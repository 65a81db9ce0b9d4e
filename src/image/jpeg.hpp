// SPDX-License-Identifier: MIT
// JPEG, by libjpeg-turbo.
#pragma once

#include <filesystem>
#include <string_view>

#include "image/bitmap.hpp"

namespace nicol {

[[nodiscard]] bool is_jpeg(std::string_view bytes);

/// Width, height and channels (1 or 3). Throws Error(invalid_file) with the file's name, as below.
void read_jpeg_header(const std::filesystem::path& file, std::string_view bytes, Bitmap& out);
/// The pixels of an image with this header. Progressive ones of more than 500 scans are refused, and large
/// ones of fewer.
void read_jpeg_pixels(const std::filesystem::path& file, std::string_view bytes, Bitmap& out);

}  // namespace nicol
