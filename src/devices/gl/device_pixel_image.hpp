// SPDX-License-Identifier: MIT
// shade at pixels on the device: its results, until the image is drawn.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "draw/pixel_image.hpp"
#include "gl/texture.hpp"
#include "versioned.hpp"

namespace nicol {

/// What a PixelImage gets. The framebuffer itself is not touched before all of an image is there.
class DevicePixelImage {
public:
    explicit DevicePixelImage(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Inside run() of the context, as all below. The content is unspecified.
    void resize(int width, int height, int channels);
    /// No surface anywhere.
    void clear();
    [[nodiscard]] gl::Texture2D& channel(int c) { return channels_[static_cast<std::size_t>(c)]; }
    [[nodiscard]] gl::Texture2D& coverage() { return coverage_.value(); }
    void copy_to(PixelImage& image) const;

private:
    std::shared_ptr<gl::Context> context_;
    std::vector<gl::Texture2D> channels_;
    std::optional<gl::Texture2D> coverage_;
    Stage<int, int, int> sizing_;
};

}  // namespace nicol
