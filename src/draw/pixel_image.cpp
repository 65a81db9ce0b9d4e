// SPDX-License-Identifier: MIT
#include "draw/pixel_image.hpp"

namespace nicol {

void PixelImage::begin(Framebuffer& target) {
    target_ = &target;
    if (coverage_ && coverage_->width() == target.width() && coverage_->height() == target.height()) return;
    coverage_.reset();
    coverage_.emplace(context_,
                      gl::TextureDescription{
                          .width = target.width(), .height = target.height(), .format = gl::Format::r32f});
}

gl::Texture2D& PixelImage::channel(int c) {
    return target_->groups_to_replace()[static_cast<std::size_t>(c / Framebuffer::kGroup)].colour(
        c % Framebuffer::kGroup);
}

}  // namespace nicol
