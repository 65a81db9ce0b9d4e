// SPDX-License-Identifier: MIT
#include "png.hpp"

#include <png.h>
#include <zlib.h>

#include "common/failure.hpp"

namespace {

void append(png_structp png, png_bytep data, png_size_t length) {
    // An exception must not pass through libpng, which is C.
    try {
        static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(data), length);
    } catch (...) {
        png_error(png, "out of memory");
    }
}

/// libpng leaves by longjmp, which must not jump over C++ objects: here live only plain values.
bool write(png_structp png, png_infop info, std::string* file, std::uint32_t width, std::uint32_t height,
           const std::uint8_t* rgb, bool srgb) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_write_fn(png, file, append, nullptr);
    png_set_IHDR(png, info, width, height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (srgb) png_set_sRGB(png, info, PNG_sRGB_INTENT_RELATIVE);
    // Of rendered pictures this is within a tenth of the size that zlib's default takes six times as long
    // for.
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_PAETH);
    png_set_compression_level(png, 1);
    png_set_compression_strategy(png, Z_RLE);
    png_write_info(png, info);
    for (std::uint32_t y = 0; y < height; ++y) png_write_row(png, rgb + std::size_t{y} * width * 3);
    png_write_end(png, nullptr);
    return true;
}

}  // namespace

std::string encode_png(std::uint32_t width, std::uint32_t height, const std::vector<std::uint8_t>& rgb,
                       bool srgb) {
    std::string file;
    const auto quiet = [](png_structp, png_const_charp) {};
    const auto leave = [](png_structp png, png_const_charp) { png_longjmp(png, 1); };
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, quiet);
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    const bool written = info != nullptr && write(png, info, &file, width, height, rgb.data(), srgb);
    png_destroy_write_struct(&png, &info);
    if (!written) throw Failure("a picture could not be written as PNG");
    return file;
}
