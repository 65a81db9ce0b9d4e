// SPDX-License-Identifier: MIT
// Results of shading at pixels, on the device.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "draw/framebuffer.hpp"
#include "gl/texture.hpp"

namespace nicol {

/// Stokes vectors of an image's surfaces, by pixel, times the fraction of the pixel that the surfaces cover;
/// and this fraction. The Stokes vectors lie in the framebuffer itself, where the environment is added to
/// them.
class PixelImage {
public:
    explicit PixelImage(std::shared_ptr<gl::Context> context) : context_(std::move(context)) {}

    /// Bytes per pixel in addition to the framebuffer's.
    static constexpr std::uint64_t kBytesPerPixel = sizeof(float);

    /// Begins an image in `target`, which must outlive its use. The content is unspecified. Must be called
    /// inside run() of the context, as all functions below.
    void begin(Framebuffer& target);
    [[nodiscard]] gl::Texture2D& channel(int c);
    /// Returns the coverage, one float per texel.
    [[nodiscard]] gl::Texture2D& coverage() { return coverage_.value(); }
    /// Frees all memory.
    void clear() { coverage_.reset(); }
    [[nodiscard]] int channels() const noexcept { return target_->channels(); }

private:
    std::shared_ptr<gl::Context> context_;
    Framebuffer* target_ = nullptr;
    std::optional<gl::Texture2D> coverage_;
};

}  // namespace nicol
