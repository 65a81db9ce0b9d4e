// SPDX-License-Identifier: MIT
#include "render/pixel_image.hpp"

namespace nicol {

void PixelImage::resize(int width, int height, int channels) {
    sizing_.run(width, height, channels, [&] {
        channels_.clear();
        for (int c = 0; c < channels; ++c)
            channels_.emplace_back(context_, gl::TextureDescription{.width = width, .height = height});
    });
}

}  // namespace nicol
