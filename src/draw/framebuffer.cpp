// SPDX-License-Identifier: MIT
#include "draw/framebuffer.hpp"

#include <algorithm>
#include <atomic>
#include <span>
#include <string>
#include <utility>

#include "draw/aov_layout.hpp"
#include "error.hpp"
#include "progress.hpp"

namespace nicol {
namespace {

// Reads the AOVs of a layout back, one attachment after the other.
void unpack(const gl::RenderTarget& attachments, const AovLayout& layout, Aovs& aovs) {
    const std::size_t pixels = static_cast<std::size_t>(aovs.width) * static_cast<std::size_t>(aovs.height);
    std::vector<float> packed(4 * pixels);
    std::vector<std::uint32_t>& ids = aovs.instances;
    for (int a = 0; a < attachments.colours(); ++a) {
        attachments.read(a, packed);
        const auto copy = [&](int place, std::size_t count, auto&& put) {
            for (std::size_t i = 0; place >= 0 && i < count; ++i) {
                const int at = place + static_cast<int>(i);
                if (at / 4 != a) continue;
                for (std::size_t p = 0; p < pixels; ++p)
                    put(p, i, packed[4 * p + static_cast<std::size_t>(at % 4)]);
            }
        };
        if (!aovs.depth.empty())
            copy(layout.depth, 1, [&](std::size_t p, std::size_t, float x) { aovs.depth[p] = x; });
        copy(layout.normals, 3, [&](std::size_t p, std::size_t i, float x) { aovs.normals[3 * p + i] = x; });
        copy(layout.positions, 3,
             [&](std::size_t p, std::size_t i, float x) { aovs.positions[3 * p + i] = x; });
        copy(layout.alpha, 1, [&](std::size_t p, std::size_t, float x) { aovs.alpha[p] = x; });
        copy(layout.instances, 2, [&](std::size_t p, std::size_t i, float x) {
            const auto half = static_cast<std::uint32_t>(x);
            ids[p] = i == 0 ? half : ids[p] | half << 16;
        });
    }
}

}  // namespace

Framebuffer::Framebuffer(std::shared_ptr<gl::Context> context, int width, int height, int channels)
    : context_(std::move(context)), mutex_(context_), width_(width), height_(height), channels_(channels) {
    const int most = context_->limits().target_size;
    if (width < 1 || height < 1 || width > most || height > most) {
        throw Error(ErrorCode::invalid_argument,
                    "a framebuffer of " + std::to_string(width) + " x " + std::to_string(height) +
                        " pixels; each side must lie in 1 to " + std::to_string(most) + " with this driver");
    }
    constexpr std::size_t most_pixels = std::size_t{1} << 26;
    if (static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > most_pixels) {
        throw Error(ErrorCode::invalid_argument, "a framebuffer of " + std::to_string(width) + " x " +
                                                     std::to_string(height) + " has more than " +
                                                     std::to_string(most_pixels) + " pixels");
    }
    context_->run([this] {
        for (int first = 0; first < channels_; first += kGroup) {
            groups_.emplace_back(
                context_,
                gl::RenderTargetDescription{
                    .width = width_, .height = height_, .colours = std::min(kGroup, channels_ - first)});
        }
    });
}

const StokesImage& Framebuffer::image() {
    if (!image_) {
        const Stopwatch watch;
        StokesImage image(width_, height_, channels_);
        const std::size_t plane = image.data.size() / static_cast<std::size_t>(channels_);
        context_->run([&] {
            for (int c = 0; c < channels_; ++c) {
                groups_[static_cast<std::size_t>(c / kGroup)].read(
                    c % kGroup, std::span(image.data).subspan(static_cast<std::size_t>(c) * plane, plane));
            }
        });
        image_ = std::move(image);
        statistics_.observe_ms += watch.milliseconds();
    }
    return *image_;
}

const Aovs& Framebuffer::aovs() {
    if (!aovs_) {
        const Stopwatch watch;
        Aovs aovs(width_, height_, aov_mask_);
        if (aov_attachments_) {
            context_->run([&] { unpack(*aov_attachments_, AovLayout(aovs_drawn_), aovs); });
        }
        aovs_ = std::move(aovs);
        statistics_.observe_ms += watch.milliseconds();
    }
    return *aovs_;
}

std::shared_ptr<gl::RenderTarget> Framebuffer::aov_attachments(std::uint32_t drawn) const {
    if (aov_attachments_ && drawn == aovs_drawn_) return aov_attachments_;
    return std::make_shared<gl::RenderTarget>(
        context_, gl::RenderTargetDescription{
                      .width = width_, .height = height_, .colours = AovLayout(drawn).attachments()});
}

void Framebuffer::drew_aovs(std::uint32_t mask, std::uint32_t drawn,
                            std::shared_ptr<gl::RenderTarget> attachments) {
    aov_mask_ = mask;
    aovs_drawn_ = drawn;
    aov_attachments_ = std::move(attachments);
    aovs_.reset();
}

void Framebuffer::show(StokesImage image, const Statistics& statistics, Aovs aovs) {
    image.check("Framebuffer::show: the image");
    aovs.check("Framebuffer::show: the AOVs");
    if (image.width != width_ || image.height != height_ || image.channels != channels_ ||
        !aovs.fit(width_, height_, channels_)) {
        throw Error(ErrorCode::invalid_argument,
                    "Framebuffer::show: the image must have the framebuffer's size and channels");
    }
    const std::size_t plane = image.data.size() / static_cast<std::size_t>(channels_);
    context_->run([&] {
        for (int c = 0; c < channels_; ++c) {
            groups_[static_cast<std::size_t>(c / kGroup)].write(
                c % kGroup,
                std::span<const float>(image.data).subspan(static_cast<std::size_t>(c) * plane, plane));
        }
    });
    rendered(statistics);
    image_ = std::move(image);
    drew_aovs(aovs.mask(), 0, nullptr);
    aovs_ = std::move(aovs);
}

void Framebuffer::rendered(const Statistics& statistics) {
    static std::atomic<std::uint64_t> contents = 0;
    content_ = ++contents;
    statistics_ = statistics;
    image_.reset();
}

}  // namespace nicol
