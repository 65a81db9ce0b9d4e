// SPDX-License-Identifier: MIT
// shade at pixels: where its results lie on the device.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "draw/framebuffer.hpp"
#include "gl/texture.hpp"

namespace nicol {

/// The Stokes vectors of an image's surfaces, by pixel, times the fraction of the pixel that they cover; and
/// this fraction. The former lie in the framebuffer itself, where the environment is added to them.
class PixelImage {
public:
    explicit PixelImage(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Beside the framebuffer's.
    static constexpr std::uint64_t kBytesPerPixel = sizeof(float);

    /// Inside run() of the context, as all below. The content is unspecified. `target` must outlive the use.
    void begin(Framebuffer& target);
    [[nodiscard]] gl::Texture2D& channel(int c);
    /// Of one float a texel.
    [[nodiscard]] gl::Texture2D& coverage() { return coverage_.value(); }
    /// Gives all memory back.
    void clear() { coverage_.reset(); }
    [[nodiscard]] int channels() const noexcept { return target_->channels(); }

private:
    std::shared_ptr<gl::Context> context_;
    Framebuffer* target_ = nullptr;
    std::optional<gl::Texture2D> coverage_;
};

}  // namespace nicol
