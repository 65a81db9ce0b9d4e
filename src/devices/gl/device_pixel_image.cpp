// SPDX-License-Identifier: MIT
#include "devices/gl/device_pixel_image.hpp"

namespace nicol {

void DevicePixelImage::resize(int width, int height, int channels) {
    sizing_.run(width, height, channels, [&] {
        channels_.clear();
        coverage_.reset();
        gl::TextureDescription size{.width = width, .height = height};
        for (int c = 0; c < channels; ++c) channels_.emplace_back(context_, size);
        size.format = gl::Format::r32f;
        coverage_.emplace(context_, size);
    });
}

void DevicePixelImage::clear() {
    for (gl::Texture2D& channel : channels_) channel.update(std::vector<float>(channel.numbers()));
    coverage_->update(std::vector<float>(coverage_->numbers()));
}

void DevicePixelImage::copy_to(PixelImage& image) const {
    for (int c = 0; c < image.channels(); ++c)
        image.channel(c).copy_from(channels_[static_cast<std::size_t>(c)]);
    image.coverage().copy_from(*coverage_);
}

}  // namespace nicol
