// SPDX-License-Identifier: MIT
// Framebuffer: the Stokes image of the last render.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gl/lending_mutex.hpp"
#include "gl/render_target.hpp"
#include "image/aovs.hpp"
#include "image/stokes_image.hpp"
#include "stage/statistics.hpp"

namespace nicol {

/// Stokes image on the device: one RGBA32F texture per colour channel, whose texels are Stokes vectors in the
/// camera's frame field. Channels form groups of at most kGroup, because a driver draws into few textures at
/// once. Threads that share a framebuffer lock mutex() around calls, except for those that get constants.
class Framebuffer {
public:
    static constexpr int kGroup = 4;

    /// Throws Error(invalid_argument) for sizes or channels out of range, and Error(out_of_memory).
    Framebuffer(std::shared_ptr<gl::Context> context, int width, int height, int channels);

    /// Makes images in textures that are not ours, one for each channel, of one size, which must outlive this
    /// object. Must be called inside run(). Throws Error(invalid_argument) that names a texture which cannot
    /// be used.
    Framebuffer(std::shared_ptr<gl::Context> context, std::span<const unsigned> textures);

    /// Returns whether the images are textures that are not ours.
    [[nodiscard]] bool borrows() const noexcept { return borrows_; }
    [[nodiscard]] int width() const noexcept { return width_; }
    [[nodiscard]] int height() const noexcept { return height_; }
    [[nodiscard]] int channels() const noexcept { return channels_; }
    [[nodiscard]] const std::shared_ptr<gl::Context>& context() const noexcept { return context_; }
    [[nodiscard]] gl::LendingMutex& mutex() noexcept { return mutex_; }

    /// Returns the groups. A group has the channels from group * kGroup on. Uploads an image that was made in
    /// memory at the first call after it.
    [[nodiscard]] std::vector<gl::RenderTarget>& groups();
    /// Returns the groups to draw over all of their pixels.
    [[nodiscard]] std::vector<gl::RenderTarget>& groups_to_replace() noexcept {
        on_device_ = true;
        return groups_;
    }

    /// Returns the image in memory, read back on first use after a render.
    [[nodiscard]] const StokesImage& image();

    /// Returns the AOVs that the last render made, as bits of AovBit.
    [[nodiscard]] std::uint32_t aov_mask() const noexcept { return aov_mask_; }
    /// Returns the AOVs of the last render in memory, read back on first use after a render.
    [[nodiscard]] const Aovs& aovs();

    /// AOVs on the device: the attachments that hold them, packed as in AovLayout, and an AOV's first float.
    struct DrawnAov {
        const gl::RenderTarget* attachments;
        int first;
    };
    /// Returns an AOV other than the variance, which the last render must have made. AOVs that were made
    /// without drawing are uploaded at the first call. Must be called inside run() of the context.
    [[nodiscard]] DrawnAov drawn_aov(AovBit aov);

    /// Replaces the content by an image that was made without drawing, and its AOVs. Throws
    /// Error(invalid_argument) unless they have this size and these channels.
    void show(StokesImage image, const Statistics& statistics, Aovs aovs = {});

    /// Returns attachments for drawing AOVs in the order of AovLayout: those of an earlier render, or new
    /// ones. Must be called inside run() of the context.
    [[nodiscard]] std::shared_ptr<gl::RenderTarget> aov_attachments(std::uint32_t drawn) const;
    /// Records that AOVs have been drawn; null: no AOVs. mask: the requested AOVs among the drawn ones. Must
    /// be called inside run() of the context.
    void drew_aovs(std::uint32_t mask, std::uint32_t drawn, std::shared_ptr<gl::RenderTarget> attachments);

    /// Exchanges contents with a framebuffer of the same size and channels. Neither may borrow its textures.
    void exchange(Framebuffer& other);

    /// Records that a render has drawn.
    void rendered(const Statistics& statistics);
    /// Exchanges the image in memory with that of a render, which must have this size and these channels.
    void rendered(StokesImage& image, const Statistics& statistics);
    [[nodiscard]] Statistics& statistics() noexcept { return statistics_; }
    /// Returns a number that identifies the content. The number is new after each render, and no other
    /// framebuffer ever has it.
    [[nodiscard]] std::uint64_t content() const noexcept { return content_; }

private:
    /// Copies the image in memory to the groups.
    void upload();
    /// Numbers the content, and keeps its statistics.
    void new_content(const Statistics& statistics);

    std::shared_ptr<gl::Context> context_;
    gl::LendingMutex mutex_;
    int width_;
    int height_;
    int channels_;
    bool borrows_ = false;
    std::vector<gl::RenderTarget> groups_;
    // Keeps its memory from one content to the next, because new pages take longer than the pixels.
    StokesImage image_;
    bool has_image_ = false;
    bool on_device_ = true;  // whether the groups have the image
    std::uint32_t aov_mask_ = 0;
    std::uint32_t aovs_drawn_ = 0;
    std::shared_ptr<gl::RenderTarget> aov_attachments_;  // attachments of aovs_drawn_; null: not drawn
    std::optional<Aovs> aovs_;
    Statistics statistics_;
    std::uint64_t content_ = 0;
};

}  // namespace nicol
