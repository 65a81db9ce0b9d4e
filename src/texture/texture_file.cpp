// SPDX-License-Identifier: MIT
// Reading of texture images from files.
#include <array>
#include <cmath>
#include <utility>

#include "files/suffix.hpp"
#include "image/color.hpp"
#include "image/exr_colors.hpp"
#include "texture/image_pixels.hpp"
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
// Decodes all values from sRGB but every `step`th; 0: all.
void decode_all_but(std::size_t step, std::vector<float>& values) {
    const std::array<float, kCodes>& table = decoded_codes();
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (step != 0 && i % step == step - 1) continue;
        float& value = values[i];
        const float code = std::nearbyint(value * (kCodes - 1));
        const bool whole = code >= 0 && code < kCodes && code / (kCodes - 1) == value;
        value = whole ? table[static_cast<std::size_t>(code)] : srgb_to_linear(value);
    }
}

}  // namespace

void decode_srgb(TextureImage& image) {
    decode_all_but(image.channels == 4 ? 4 : 0, image.values);
}

ImagePixels::ImagePixels(Bitmap bitmap, bool raw) : bitmap_(std::move(bitmap)) {
    const bool encoded = !raw && !bitmap_.linear;
    const std::size_t coverage = bitmap_.channels % 2 == 0 ? static_cast<std::size_t>(bitmap_.channels) : 0;
    if (encoded) decode_all_but(coverage, bitmap_.values);
    for (std::size_t n = 0; n < colors_.size(); ++n)
        colors_[n] = encoded ? decoded_codes()[257 * n] : static_cast<float>(n) / 255;
}

TextureImage ImagePixels::image() const {
    TextureImage out{.width = width(), .height = height(), .channels = channels(), .values = {}};
    out.values.reserve(count() * static_cast<std::size_t>(channels()));
    for (std::size_t i = 0; i < count(); ++i) {
        const glm::vec4 pixel = at(i);
        for (glm::length_t c = 0; c < channels(); ++c) out.values.push_back(pixel[c]);
    }
    return out;
}

ImagePixels load_image_pixels(const std::filesystem::path& file, bool raw, const LoadBudget& budget) {
    return {suffix_of(file) == ".exr" ? read_exr_colors(file, budget)
                                      : read_bitmap(file, budget, BitmapValues::codes),
            raw};
}

ImagePixels load_image_pixels(const std::filesystem::path& file, std::string_view bytes, bool raw,
                              const LoadBudget& budget) {
    return {read_bitmap(file, bytes, budget, BitmapValues::codes), raw};
}

TextureImage load_texture_image(const std::filesystem::path& file, bool raw, const LoadBudget& budget) {
    return load_image_pixels(file, raw, budget).image();
}

}  // namespace nicol
