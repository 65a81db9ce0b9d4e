// SPDX-License-Identifier: MIT
// Reading of texture images from files.
#include <array>
#include <cmath>
#include <utility>

#include "files/suffix.hpp"
#include "image/color.hpp"
#include "image/exr_colors.hpp"
#include "texture/texture.hpp"

namespace nicol {
namespace {

/// Number of 16-bit codes. The table also serves 8-bit codes, because n / 255 is 257 n / 65535.
constexpr int kCodes = 65536;

const std::array<float, kCodes>& decoded_codes() {
    static const std::array<float, kCodes> table = [] {
        std::array<float, kCodes> linear{};
        for (int n = 0; n < kCodes; ++n)
            linear[static_cast<std::size_t>(n)] = srgb_to_linear(static_cast<float>(n) / (kCodes - 1));
        return linear;
    }();
    return table;
}

/// Returns grey with coverage as red, green, blue and coverage.
std::vector<float> four_channels(const std::vector<float>& two) {
    std::vector<float> out;
    out.reserve(2 * two.size());
    for (std::size_t i = 0; i < two.size(); i += 2)
        out.insert(out.end(), {two[i], two[i], two[i], two[i + 1]});
    return out;
}

TextureImage image_of(Bitmap bitmap, bool raw) {
    TextureImage image{
        .width = bitmap.width,
        .height = bitmap.height,
        .channels = bitmap.channels == 2 ? 4 : bitmap.channels,
        .values = bitmap.channels == 2 ? four_channels(bitmap.values) : std::move(bitmap.values)};
    if (!raw && !bitmap.linear) decode_srgb(image);
    return image;
}

}  // namespace

void decode_srgb(TextureImage& image) {
    const std::array<float, kCodes>& table = decoded_codes();
    for (std::size_t i = 0; i < image.values.size(); ++i) {
        if (image.channels == 4 && i % 4 == 3) continue;
        float& value = image.values[i];
        const float code = std::nearbyint(value * (kCodes - 1));
        const bool whole = code >= 0 && code < kCodes && code / (kCodes - 1) == value;
        value = whole ? table[static_cast<std::size_t>(code)] : srgb_to_linear(value);
    }
}

TextureImage load_texture_image(const std::filesystem::path& file, bool raw, const LoadBudget& budget) {
    return image_of(suffix_of(file) == ".exr" ? read_exr_colors(file, budget) : read_bitmap(file, budget),
                    raw);
}

TextureImage load_texture_image(const std::filesystem::path& file, std::string_view bytes, bool raw,
                                const LoadBudget& budget) {
    return image_of(read_bitmap(file, bytes, budget), raw);
}

}  // namespace nicol
