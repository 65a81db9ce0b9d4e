// SPDX-License-Identifier: MIT
// Pixels of an image file that are decoded where they are used.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/vec4.hpp>
#include <string_view>
#include <vector>

#include "files/load_budget.hpp"
#include "image/bitmap.hpp"
#include "texture/texture.hpp"

namespace nicol {

/// Pixels of load_texture_image(). Those of 8 bits are kept in the file's numbers, which take a quarter of
/// the memory of decoded ones.
class ImagePixels {
public:
    ImagePixels() = default;
    /// raw: as for load_texture_image().
    ImagePixels(Bitmap bitmap, bool raw);

    [[nodiscard]] int width() const noexcept { return bitmap_.width; }
    [[nodiscard]] int height() const noexcept { return bitmap_.height; }
    [[nodiscard]] std::size_t count() const noexcept {
        return static_cast<std::size_t>(width()) * static_cast<std::size_t>(height());
    }
    /// Returns 1, 3, or 4 (with coverage).
    [[nodiscard]] int channels() const noexcept { return bitmap_.channels == 2 ? 4 : bitmap_.channels; }
    /// Returns red, green, blue and coverage of the pixel number i, row by row from the top.
    [[nodiscard]] glm::vec4 at(std::size_t i) const {
        const auto step = static_cast<std::size_t>(bitmap_.channels);
        const auto color = [&](std::size_t c) {
            return bitmap_.codes.empty() ? bitmap_.values[i * step + c]
                                         : colors_[bitmap_.codes[i * step + c]];
        };
        const auto number = [&](std::size_t c) {
            return bitmap_.codes.empty() ? bitmap_.values[i * step + c]
                                         : static_cast<float>(bitmap_.codes[i * step + c]) / 255;
        };
        if (step >= 3) return {color(0), color(1), color(2), step == 4 ? number(3) : 1.0F};
        const float grey = color(0);
        return {grey, grey, grey, step == 2 ? number(1) : 1.0F};
    }

    /// Returns all pixels with channels() values each.
    [[nodiscard]] TextureImage image() const;

private:
    Bitmap bitmap_;
    std::array<float, 256> colors_{};  // values of the codes of colours
};

/// Reads the pixels of load_texture_image(); of bytes, not of EXR. Their `file` is their name and is not
/// opened.
[[nodiscard]] ImagePixels load_image_pixels(const std::filesystem::path& file, bool raw,
                                            const LoadBudget& budget = {});
[[nodiscard]] ImagePixels load_image_pixels(const std::filesystem::path& file, std::string_view bytes,
                                            bool raw, const LoadBudget& budget = {});

}  // namespace nicol
