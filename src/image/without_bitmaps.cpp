// SPDX-License-Identifier: MIT
// Bitmaps in builds without their files.
#include "files/file_error.hpp"
#include "image/bitmap.hpp"
#include "image/png.hpp"

namespace nicol {
namespace {

[[noreturn]] void refuse_bitmap(const std::filesystem::path& file) {
    refuse_left_out_format(file, "PNG, JPEG, BMP, TGA and HDR files", "NICOL_BITMAPS");
}

}  // namespace

Bitmap read_bitmap(const std::filesystem::path& file, const LoadBudget& /*budget*/, BitmapValues /*values*/) {
    refuse_bitmap(file);
}

Bitmap read_bitmap(const std::filesystem::path& file, std::string_view /*bytes*/,
                   const LoadBudget& /*budget*/, BitmapValues /*values*/) {
    refuse_bitmap(file);
}

void write_png(const std::filesystem::path& path, const PngImage& /*image*/) {
    refuse_bitmap(path);
}

void encode_png(std::FILE* /*file*/, const std::string& name, const PngImage& /*image*/) {
    refuse_bitmap(name);
}

}  // namespace nicol
