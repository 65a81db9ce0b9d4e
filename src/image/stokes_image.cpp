// SPDX-License-Identifier: MIT
#include "image/stokes_image.hpp"

#include <algorithm>
#include <cmath>

#include "error.hpp"

namespace nicol {
namespace {

std::string size_text(int width, int height, int channels) {
    return std::to_string(width) + " x " + std::to_string(height) + " pixels with " +
           std::to_string(channels) + " channels";
}

void check_sizes(const char* what, int width, int height, int channels) {
    const bool sides = width >= 1 && height >= 1 && width <= kMaxImageSide && height <= kMaxImageSide;
    if (sides && channels >= 1 && channels <= 4096) {
        const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        if (pixels <= kMaxImagePixels && pixels * static_cast<std::size_t>(channels) <= kMaxImageVectors)
            return;
    }
    throw Error(ErrorCode::invalid_argument,
                std::string(what) + ": " + size_text(width, height, channels) + "; sides must be 1 to " +
                    std::to_string(kMaxImageSide) + ", pixels at most " + std::to_string(kMaxImagePixels) +
                    ", times channels at most " + std::to_string(kMaxImageVectors) + ", channels 1 to 4096");
}

std::size_t element_count(int width, int height, int channels) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
           static_cast<std::size_t>(channels) * 4;
}

std::size_t offset(const StokesImage& image, int channel, int y, int x) {
    if (channel < 0 || channel >= image.channels || y < 0 || y >= image.height || x < 0 || x >= image.width)
        throw Error(ErrorCode::invalid_argument, "channel " + std::to_string(channel) + ", y " +
                                                     std::to_string(y) + ", x " + std::to_string(x) +
                                                     " lies outside an image of " +
                                                     size_text(image.width, image.height, image.channels));
    const auto width = static_cast<std::size_t>(image.width);
    const auto height = static_cast<std::size_t>(image.height);
    const std::size_t row = static_cast<std::size_t>(channel) * height + static_cast<std::size_t>(y);
    const std::size_t element = (row * width + static_cast<std::size_t>(x)) * 4;
    if (element + 4 > image.data.size())
        throw Error(ErrorCode::invalid_argument, "the image's data is shorter than its sizes say");
    return element;
}

}  // namespace

StokesImage::StokesImage(int width_, int height_, int channels_)
    : width(width_), height(height_), channels(channels_) {
    check_sizes("StokesImage", width, height, channels);
    data.resize(element_count(width, height, channels));
}

std::span<float, 4> StokesImage::at(int channel, int y, int x) {
    return std::span<float, 4>(data.data() + offset(*this, channel, y, x), 4);
}

std::span<const float, 4> StokesImage::at(int channel, int y, int x) const {
    return std::span<const float, 4>(data.data() + offset(*this, channel, y, x), 4);
}

Stokes StokesImage::stokes(int channel, int y, int x) const {
    const auto s = at(channel, y, x);
    return {s[0], s[1], s[2], s[3]};
}

void StokesImage::check(const char* what) const {
    check_sizes(what, width, height, channels);
    const std::size_t expected = element_count(width, height, channels);
    if (data.size() != expected)
        throw Error(ErrorCode::invalid_argument,
                    std::string(what) + ": data has " + std::to_string(data.size()) + " elements; " +
                        size_text(width, height, channels) + " need " + std::to_string(expected));
    const bool valid =
        std::ranges::all_of(wavelengths, [](double nm) { return nm > 0 && std::isfinite(nm); });
    if (!valid || (!wavelengths.empty() && wavelengths.size() != static_cast<std::size_t>(channels)))
        throw Error(ErrorCode::invalid_argument,
                    std::string(what) + ": wavelengths must be empty or one finite value > 0 a channel");
}

}  // namespace nicol
