// SPDX-License-Identifier: MIT
// PNG files of any numbers: grey or R G B, 8 or 16 bits.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace nicol {

/// First bytes of every PNG file.
inline constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";

struct PngImage {
    int width = 0;
    int height = 0;
    bool grey = false;                      ///< one number per pixel, or else R G B
    bool deep = false;                      ///< 16 bits per number, more significant byte first, or else 8
    std::span<const std::uint8_t> bytes{};  ///< [y][x][number], row 0 at the top
    std::span<const std::pair<std::string, std::string>> text{};  ///< keyword and text of tEXt chunks
    bool srgb = false;                                            ///< whether the file gets an sRGB chunk
    /// Whether the numbers are noise, in which zlib finds no repetitions but runs: differences from the row
    /// above with Huffman codes take a tenth of the default's time and 4 % more bytes.
    bool noisy = false;
};

/// Writes a PNG to an open file, which messages call `name`. Throws Error(invalid_argument) if the sizes do
/// not fit, or if a keyword or text is not fit for tEXt (keyword 1 to 79 bytes); Error(write_failed).
void encode_png(std::FILE* file, const std::string& name, const PngImage& image);

/// Writes a PNG. The file appears under its name only when it is complete. Throws what encode_png() throws.
void write_png(const std::filesystem::path& path, const PngImage& image);

}  // namespace nicol
