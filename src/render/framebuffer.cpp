// SPDX-License-Identifier: MIT
#include "render/framebuffer.hpp"

#include <algorithm>
#include <atomic>
#include <span>
#include <string>
#include <utility>

#include "nicol/error.hpp"
#include "render/stopwatch.hpp"

namespace nicol {

Framebuffer::Framebuffer(std::shared_ptr<gl::Context> context, int width, int height, int channels)
    : context_(std::move(context)), width_(width), height_(height), channels_(channels) {
    const int most = context_->limits().target_size;
    if (width < 1 || height < 1 || width > most || height > most) {
        throw Error(ErrorCode::invalid_argument,
                    "a framebuffer of " + std::to_string(width) + " x " + std::to_string(height) +
                        " pixels; each side must lie in 1 to " + std::to_string(most) + " with this driver");
    }
    if (static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > kMaxImagePixels) {
        throw Error(ErrorCode::invalid_argument, "a framebuffer of " + std::to_string(width) + " x " +
                                                     std::to_string(height) + " has more than " +
                                                     std::to_string(kMaxImagePixels) + " pixels");
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

void Framebuffer::show(StokesImage image, const Statistics& statistics) {
    image.check("Framebuffer::show: the picture");
    if (image.width != width_ || image.height != height_ || image.channels != channels_) {
        throw Error(ErrorCode::invalid_argument,
                    "Framebuffer::show: the picture must have the framebuffer's size and channels");
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
}

void Framebuffer::rendered(const Statistics& statistics) {
    static std::atomic<std::uint64_t> contents = 0;
    content_ = ++contents;
    statistics_ = statistics;
    image_.reset();
}

}  // namespace nicol
