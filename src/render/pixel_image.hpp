// SPDX-License-Identifier: MIT
// shade at pixels: where its results lie on the device.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "gl/texture.hpp"
#include "versioned.hpp"

namespace nicol {

/// The Stokes vectors of an image's surfaces on the device, by pixel, times the fraction of the pixel that
/// they cover; and this fraction.
class PixelImage {
public:
    explicit PixelImage(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Inside run() of the context, as all below. The content is unspecified.
    void resize(int width, int height, int channels);
    [[nodiscard]] gl::Texture2D& channel(int c) { return channels_[static_cast<std::size_t>(c)]; }
    /// The fraction is the first component.
    [[nodiscard]] gl::Texture2D& coverage() { return coverage_.value(); }
    [[nodiscard]] int channels() const noexcept { return static_cast<int>(channels_.size()); }

private:
    std::shared_ptr<gl::Context> context_;
    std::vector<gl::Texture2D> channels_;
    std::optional<gl::Texture2D> coverage_;
    Stage<int, int, int> sizing_;
};

}  // namespace nicol
