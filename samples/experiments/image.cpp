// SPDX-License-Identifier: MIT
#include "image.hpp"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace {

unsigned char byte(double x) {
    return static_cast<unsigned char>(std::lround(255 * std::clamp(x, 0.0, 1.0)));
}

}  // namespace

void Image::add(const Panel& panel, Signed colours) {
    Coloured out{panel.width, panel.height, {}};
    for (const double value : panel.values) {
        const double x = std::clamp(value / colours.scale, -1.0, 1.0);
        out.rgb.push_back(byte(x < 0 ? 1 + 0.9 * x : 1 - 0.2 * x));
        out.rgb.push_back(byte(1 - 0.85 * std::abs(x)));
        out.rgb.push_back(byte(x < 0 ? 1 + 0.2 * x : 1 - 0.9 * x));
    }
    panels_.push_back(std::move(out));
}

void Image::add(const Panel& panel, Magnitude colours) {
    Coloured out{panel.width, panel.height, {}};
    for (const double value : panel.values) {
        const double size = std::max(std::abs(value) / colours.scale, 1e-300);
        const unsigned char grey = byte(-std::log10(size) / colours.decades);
        out.rgb.insert(out.rgb.end(), 3, grey);
    }
    panels_.push_back(std::move(out));
}

void Image::write(const std::string& path, std::size_t zoom) const {
    constexpr std::size_t gap = 8;
    const std::size_t w = panels_.at(0).width * zoom, h = panels_.at(0).height * zoom;
    const std::size_t down = (panels_.size() + across_ - 1) / across_;
    const std::size_t width = across_ * (w + gap) - gap, height = down * (h + gap) - gap;
    std::vector<unsigned char> rgb(3 * width * height, 128);
    for (std::size_t i = 0; i < panels_.size(); ++i) {
        const std::size_t left = i % across_ * (w + gap), top = i / across_ * (h + gap);
        for (std::size_t y = 0; y < h; ++y)
            for (std::size_t x = 0; x < w; ++x) {
                const std::size_t from = y / zoom * panels_[i].width + x / zoom;
                std::copy_n(&panels_[i].rgb[3 * from], 3, &rgb[3 * ((top + y) * width + left + x)]);
            }
    }
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(width);
    image.height = static_cast<png_uint_32>(height);
    image.format = PNG_FORMAT_RGB;
    if (png_image_write_to_file(&image, path.c_str(), 0, rgb.data(), 0, nullptr) == 0)
        throw std::runtime_error(path + ": " + image.message);
}
