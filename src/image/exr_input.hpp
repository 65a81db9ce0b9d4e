// SPDX-License-Identifier: MIT
// Checked opening and reading of OpenEXR files, and the pixels of their display windows.
#pragma once

#include <ImathBox.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "error.hpp"
#include "files/load_budget.hpp"
#include "image/stokes_image.hpp"

namespace nicol {

/// Calls read() with the opened file after checking the file's structure. Throws Error(file_not_found), what
/// check_exr_structure() throws, and Error(invalid_file) if OpenEXR finds the file damaged.
void read_exr_input(const std::filesystem::path& file, const LoadBudget& budget,
                    const std::function<void(Imf::MultiPartInputFile& input)>& read);

/// Reads all rows of a part into its frame buffer and checks `budget` in between.
void read_exr_rows(Imf::InputPart& part, const LoadBudget& budget);

/// Throws Error(invalid_file) that names channel and pixel, counted from the top left, unless the value is
/// finite.
void require_finite_pixel(const std::filesystem::path& file, const std::string& channel, std::size_t pixel,
                          int width, float value);

[[nodiscard]] inline std::size_t columns_of(const Imath::Box2i& window) {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(window.max.x) - window.min.x + 1);
}
[[nodiscard]] inline std::size_t rows_of(const Imath::Box2i& window) {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(window.max.y) - window.min.y + 1);
}

/// Throws Error(unsupported) if the display window is beyond kMaxImageSide or kMaxImagePixels.
inline void check_display_window(const std::filesystem::path& file, const Imath::Box2i& display) {
    const std::size_t columns = columns_of(display), rows = rows_of(display);
    if (columns > kMaxImageSide || rows > kMaxImageSide || columns * rows > kMaxImagePixels)
        throw Error(ErrorCode::unsupported, file.string() + ": the display window has " +
                                                std::to_string(columns) + " x " + std::to_string(rows) +
                                                " pixels; sides may be at most " +
                                                std::to_string(kMaxImageSide) + " and pixels at most " +
                                                std::to_string(kMaxImagePixels));
}

/// Returns the pixels of the display window, of `floats` numbers each. Pixels outside the data window are 0.
[[nodiscard]] inline std::vector<float> displayed(std::span<const float> pixels, std::size_t floats,
                                                  const Imath::Box2i& data, const Imath::Box2i& display) {
    std::vector<float> image(columns_of(display) * rows_of(display) * floats, 0.0F);
    const int left = std::max(data.min.x, display.min.x), right = std::min(data.max.x, display.max.x);
    const int top = std::max(data.min.y, display.min.y), bottom = std::min(data.max.y, display.max.y);
    if (left > right) return image;
    const Imath::Box2i shared({left, top}, {right, bottom});
    for (int y = top; y <= bottom; ++y) {
        const auto place = [&](const Imath::Box2i& window) {
            const std::size_t row = rows_of({window.min, {left, y}}) - 1;
            const std::size_t column = columns_of({window.min, {left, y}}) - 1;
            return (row * columns_of(window) + column) * floats;
        };
        std::ranges::copy(pixels.subspan(place(data), columns_of(shared) * floats),
                          image.begin() + static_cast<std::ptrdiff_t>(place(display)));
    }
    return image;
}

}  // namespace nicol
