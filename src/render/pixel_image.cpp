// SPDX-License-Identifier: MIT
#include "render/pixel_image.hpp"

namespace nicol {

void PixelImage::resize(int width, int height, int channels) {
    sizing_.run(width, height, channels, [&] {
        channels_.clear();
        coverage_.reset();
        const gl::TextureDescription size{.width = width, .height = height};
        for (int c = 0; c < channels; ++c) channels_.emplace_back(context_, size);
        coverage_.emplace(context_, size);
    });
}

}  // namespace nicol
