// SPDX-License-Identifier: MIT
#include "image/bitmap.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "files/suffix.hpp"
#include "image/color.hpp"

namespace nicol {
namespace {

constexpr std::array<std::string_view, 7> kSuffixes = {".png", ".jpg", ".jpeg", ".bmp",
                                                       ".tga", ".hdr", ".rgbe"};

}  // namespace

bool is_bitmap(const std::filesystem::path& file) {
    return std::ranges::find(kSuffixes, std::string_view(suffix_of(file))) != kSuffixes.end();
}

StokesImage unpolarized_image(const Bitmap& bitmap) {
    const int colours = bitmap.channels < 3 ? 1 : 3;
    StokesImage image(bitmap.width, bitmap.height, colours);
    const std::size_t pixels =
        static_cast<std::size_t>(bitmap.width) * static_cast<std::size_t>(bitmap.height);
    const auto step = static_cast<std::size_t>(bitmap.channels);
    for (std::size_t c = 0; c < static_cast<std::size_t>(colours); ++c)
        for (std::size_t i = 0; i < pixels; ++i) {
            const float value = bitmap.values[i * step + c];
            image.data[4 * (c * pixels + i)] = bitmap.linear ? value : srgb_to_linear(value);
        }
    return image;
}

}  // namespace nicol
