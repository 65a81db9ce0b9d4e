// SPDX-License-Identifier: MIT
// The Stokes image of the last render into it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "gl/render_target.hpp"
#include "image/aovs.hpp"
#include "image/stokes_image.hpp"
#include "stage/statistics.hpp"

namespace nicol {

/// One RGBA32F texture a colour channel, whose texel is the Stokes vector in the camera's frame field.
/// Channels go in groups of at most kGroup, since a driver draws into few textures at once.
class Framebuffer {
public:
    static constexpr int kGroup = 4;

    /// Throws Error(invalid_argument) for sizes or channels out of range, Error(out_of_memory).
    Framebuffer(std::shared_ptr<gl::Context> context, int width, int height, int channels);

    [[nodiscard]] int width() const noexcept { return width_; }
    [[nodiscard]] int height() const noexcept { return height_; }
    [[nodiscard]] int channels() const noexcept { return channels_; }
    [[nodiscard]] const std::shared_ptr<gl::Context>& context() const noexcept { return context_; }

    /// Channels group * kGroup and following.
    [[nodiscard]] std::vector<gl::RenderTarget>& groups() noexcept { return groups_; }

    /// The image in memory, read back on first use after a render.
    [[nodiscard]] const StokesImage& image();

    /// Which AOVs the last render made, as bits of AovBit.
    [[nodiscard]] std::uint32_t aov_mask() const noexcept { return aov_mask_; }
    /// These AOVs in memory, read back on first use after a render.
    [[nodiscard]] const Aovs& aovs();

    /// Takes an image that was made without drawing, and its AOVs. Throws
    /// Error(invalid_argument) unless they have this size and these channels.
    void show(StokesImage image, const Statistics& statistics, Aovs aovs = {});

    /// Where to draw these AOVs, as AovLayout says: attachments that an earlier render left, or new ones.
    /// Inside run().
    [[nodiscard]] std::shared_ptr<gl::RenderTarget> aov_attachments(std::uint32_t drawn) const;
    /// To be called once they are drawn; null: no AOVs. `mask`: those of the drawn ones that were asked for.
    /// Inside run().
    void drew_aovs(std::uint32_t mask, std::uint32_t drawn, std::shared_ptr<gl::RenderTarget> attachments);

    /// To be called once a render has drawn.
    void rendered(const Statistics& statistics);
    [[nodiscard]] Statistics& statistics() noexcept { return statistics_; }
    /// Names what it holds: another number after each render, which no other framebuffer ever has.
    [[nodiscard]] std::uint64_t content() const noexcept { return content_; }

private:
    std::shared_ptr<gl::Context> context_;
    int width_;
    int height_;
    int channels_;
    std::vector<gl::RenderTarget> groups_;
    std::optional<StokesImage> image_;
    std::uint32_t aov_mask_ = 0;
    std::uint32_t aovs_drawn_ = 0;
    std::shared_ptr<gl::RenderTarget> aov_attachments_;  // of aovs_drawn_; null where they were not drawn
    std::optional<Aovs> aovs_;
    Statistics statistics_;
    std::uint64_t content_ = 0;
};

}  // namespace nicol
