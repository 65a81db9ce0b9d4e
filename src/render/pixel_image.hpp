// SPDX-License-Identifier: MIT
// shade at pixels: where its results lie on the device.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "gl/texture.hpp"
#include "versioned.hpp"

namespace nicol {

/// The Stokes vectors of an image's pixels on the device.
class PixelImage {
public:
    explicit PixelImage(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Inside run() of the context, as all below. The content is unspecified.
    void resize(int width, int height, int channels);
    [[nodiscard]] gl::Texture2D& channel(int c) { return channels_[static_cast<std::size_t>(c)]; }
    [[nodiscard]] int channels() const noexcept { return static_cast<int>(channels_.size()); }

private:
    std::shared_ptr<gl::Context> context_;
    std::vector<gl::Texture2D> channels_;
    Stage<int, int, int> sizing_;
};

}  // namespace nicol
