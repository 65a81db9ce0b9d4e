// SPDX-License-Identifier: MIT
#include "devices/gl/device_pixel_image.hpp"

#include <vector>

namespace nicol {

void DevicePixelImage::resize(int width, int height, int channels) {
    sizing_.run(width, height, channels, [&] {
        channels_.reset();
        coverage_.reset();
        channels_.emplace(context_, width, height, channels);
        coverage_.emplace(
            context_, gl::TextureDescription{.width = width, .height = height, .format = gl::Format::r32f});
    });
}

void DevicePixelImage::clear() {
    channels_->clear();
    coverage_->update(std::vector<float>(coverage_->numbers()));
}

void DevicePixelImage::copy_to(PixelImage& image) const {
    for (int c = 0; c < image.channels(); ++c) channels_->copy_layer(c, image.channel(c));
    image.coverage().copy_from(*coverage_);
}

}  // namespace nicol
