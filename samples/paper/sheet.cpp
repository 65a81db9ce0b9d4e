// SPDX-License-Identifier: MIT
#include "sheet.hpp"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "font.hpp"

namespace {

constexpr std::uint8_t kBackground = 24;

class Canvas {
public:
    Canvas(std::size_t width, std::size_t height)
        : width_(width), height_(height), rgb_(3 * width * height, kBackground) {}

    void draw(const Panel& panel, std::size_t left, std::size_t top) {
        for (std::size_t y = 0; y < panel.size; ++y) {
            std::copy_n(&panel.rgb[3 * y * panel.size], 3 * panel.size,
                        &rgb_[3 * ((top + y) * width_ + left)]);
        }
    }

    // Writes text. Parts outside the image are cut off.
    void write(const std::string& text, std::size_t left, std::size_t top, std::size_t scale) {
        for (std::size_t i = 0; i < text.size(); ++i) {
            for (std::size_t y = 0; y < kGlyphHeight * scale; ++y) {
                for (std::size_t x = 0; x < kGlyphWidth * scale; ++x) {
                    const std::size_t u = left + i * kGlyphAdvance * scale + x, v = top + y;
                    if (u >= width_ || v >= height_ || !glyph_pixel(text[i], x / scale, y / scale)) continue;
                    std::fill_n(&rgb_[3 * (v * width_ + u)], 3, std::uint8_t{224});
                }
            }
        }
    }

    void save(const std::string& path) const {
        png_image image{};
        image.version = PNG_IMAGE_VERSION;
        image.width = static_cast<png_uint_32>(width_);
        image.height = static_cast<png_uint_32>(height_);
        image.format = PNG_FORMAT_RGB;
        if (png_image_write_to_file(&image, path.c_str(), 0, rgb_.data(), 0, nullptr) == 0) {
            throw std::runtime_error(path + ": " + image.message);
        }
    }

private:
    std::size_t width_, height_;
    std::vector<std::uint8_t> rgb_;
};

}  // namespace

void Sheet::add_row(std::string name, std::vector<Panel> panels) {
    rows_.push_back({std::move(name), std::move(panels)});
}

void Sheet::write(const std::string& path) const {
    const std::size_t panel = rows_.at(0).panels.at(0).size;
    // Letters grow with the panels, in whole pixels, so that notes fit.
    const std::size_t large = std::max<std::size_t>(panel / 170, 1),
                      small = std::max<std::size_t>(large - 1, 1);
    const std::size_t gap = 3 * large, strip = (kGlyphHeight + 4) * large, line = (kGlyphHeight + 3) * small;
    const std::size_t width = gap + columns_.size() * (panel + gap);
    const std::size_t height = strip + rows_.size() * (strip + panel) + 2 * gap + notes_.size() * line;
    Canvas canvas(width, height);
    for (std::size_t c = 0; c < columns_.size(); ++c) {
        const std::size_t text = columns_[c].size() * kGlyphAdvance * large;
        const std::size_t middle = gap + c * (panel + gap) + panel / 2;
        canvas.write(columns_[c], middle - std::min(middle, text / 2), 3 * large, large);
    }
    std::size_t top = strip;
    for (const Row& row : rows_) {
        canvas.write(row.name, gap, top + 3 * large, large);
        top += strip;
        for (std::size_t c = 0; c < row.panels.size(); ++c) {
            canvas.draw(row.panels[c], gap + c * (panel + gap), top);
        }
        top += panel;
    }
    top += 2 * gap;
    for (const std::string& note : notes_) {
        canvas.write(note, gap, top, small);
        top += line;
    }
    canvas.save(path);
}
