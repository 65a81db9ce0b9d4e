// SPDX-License-Identifier: MIT
// Results of shading at pixels on the device, until the image is drawn.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "draw/pixel_image.hpp"
#include "gl/texture.hpp"
#include "gl/texture_array.hpp"
#include "versioned.hpp"

namespace nicol {

/// Content for a PixelImage. The framebuffer itself is not touched before an image is complete.
class DevicePixelImage {
public:
    explicit DevicePixelImage(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Allocates an image, whose content is unspecified. Must be called inside run() of the context, as all
    /// functions below.
    void resize(int width, int height, int channels);
    /// Clears the image: no pixel shows a surface.
    void clear();
    [[nodiscard]] gl::TextureArray& channels() { return channels_.value(); }
    [[nodiscard]] gl::Texture2D& coverage() { return coverage_.value(); }
    void copy_to(PixelImage& image) const;

private:
    std::shared_ptr<gl::Context> context_;
    std::optional<gl::TextureArray> channels_;
    std::optional<gl::Texture2D> coverage_;
    Stage<int, int, int> sizing_;
};

}  // namespace nicol
