// SPDX-License-Identifier: MIT
#include "png.hpp"

#include <libdeflate.h>

#include <array>
#include <cstdlib>
#include <string_view>

#include "deflate.hpp"

namespace {

constexpr std::size_t kPixelBytes = 3;
constexpr char kPaethFilter = 4;

std::string big_endian(std::size_t value) {
    std::string bytes;
    for (unsigned shift = 32; shift > 0; shift -= 8) bytes += static_cast<char>(value >> (shift - 8) & 0xffu);
    return bytes;
}

void chunk(std::string& file, std::string_view type, std::string_view data) {
    file += big_endian(data.size());
    const std::size_t begin = file.size();
    file += type;
    file += data;
    file += big_endian(libdeflate_crc32(0, file.data() + begin, file.size() - begin));
}

/// Returns left, above or the corner between them, whichever is nearest to left + above - corner.
int paeth(int left, int above, int corner) {
    const int from_left = std::abs(above - corner), from_above = std::abs(left - corner),
              from_corner = std::abs(left + above - 2 * corner);
    if (from_left <= from_above && from_left <= from_corner) return left;
    return from_above <= from_corner ? above : corner;
}

/// Returns each row's filter and the filtered row.
std::string filtered(std::size_t stride, std::uint32_t height, const std::vector<std::uint8_t>& rgb) {
    std::string result((stride + 1) * height, '\0');
    const std::vector<std::uint8_t> nothing(stride);
    const std::uint8_t* above = nothing.data();
    for (std::uint32_t y = 0; y < height; ++y) {
        const std::uint8_t* row = rgb.data() + y * stride;
        char* to = result.data() + y * (stride + 1);
        *to++ = kPaethFilter;
        for (std::size_t x = 0; x < kPixelBytes; ++x) to[x] = static_cast<char>(row[x] - above[x]);
        for (std::size_t x = kPixelBytes; x < stride; ++x)
            to[x] = static_cast<char>(row[x] - paeth(row[x - kPixelBytes], above[x], above[x - kPixelBytes]));
        above = row;
    }
    return result;
}

}  // namespace

std::string encode_png(std::uint32_t width, std::uint32_t height, const std::vector<std::uint8_t>& rgb,
                       bool srgb) {
    constexpr std::array<char, 5> colours = {8, 2, 0, 0, 0};  // 8-bit R G B
    std::string file = "\x89PNG\r\n\x1a\n";
    chunk(file, "IHDR", big_endian(width) + big_endian(height) + std::string(colours.begin(), colours.end()));
    if (srgb) chunk(file, "sRGB", std::string_view("\1", 1));  // relative colorimetric
    chunk(file, "IDAT", deflated(filtered(kPixelBytes * width, height, rgb), Deflate::speed));
    chunk(file, "IEND", {});
    return file;
}
