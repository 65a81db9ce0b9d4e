// SPDX-License-Identifier: MIT
#include "draw/framebuffer.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <iterator>
#include <span>
#include <string>
#include <utility>

#include "draw/aov_layout.hpp"
#include "error.hpp"
#include "progress.hpp"

namespace nicol {
namespace {

// AOV of floats, and its place in a layout.
template <class Values>
struct FloatAov {
    int place;
    std::size_t count;  // floats of a pixel
    Values* values;
};
// Clang 14 deduces no aggregates.
template <class Values>
FloatAov(int, std::size_t, Values*) -> FloatAov<Values>;

// Calls visit(component, aov, i) for each float i of an AOV that an attachment holds, where `component` is
// the float's place in the attachment's texels. `aovs` is Aovs, constant or not.
template <class AnyAovs, class Visit>
void visit_floats(const AovLayout& layout, int attachment, AnyAovs& aovs, Visit visit) {
    const std::array all{FloatAov{layout.normals, 3, &aovs.normals}, FloatAov{layout.depth, 1, &aovs.depth},
                         FloatAov{layout.positions, 3, &aovs.positions},
                         FloatAov{layout.alpha, 1, &aovs.alpha}};
    for (const auto& aov : all) {
        // Depth may be drawn for the sake of other AOVs alone.
        if (aov.place < 0 || aov.values->empty()) continue;
        for (std::size_t i = 0; i < aov.count; ++i) {
            const int at = aov.place + static_cast<int>(i);
            if (at / 4 == attachment) visit(static_cast<std::size_t>(at % 4), aov, i);
        }
    }
}

// Calls visit(component, shift) for each half of the instances' ids that an attachment holds.
template <class Visit>
void visit_ids(const AovLayout& layout, int attachment, Visit visit) {
    for (int half = 0; layout.instances >= 0 && half < 2; ++half) {
        const int at = layout.instances + half;
        if (at / 4 == attachment) visit(static_cast<std::size_t>(at % 4), 16 * half);
    }
}

// Reads the AOVs of a layout back, one attachment after the other.
void unpack(const gl::RenderTarget& attachments, const AovLayout& layout, Aovs& aovs) {
    const std::size_t pixels = static_cast<std::size_t>(aovs.width) * static_cast<std::size_t>(aovs.height);
    std::vector<float> packed(4 * pixels);
    for (int a = 0; a < attachments.colours(); ++a) {
        attachments.read(a, packed);
        visit_floats(layout, a, aovs, [&](std::size_t component, const auto& aov, std::size_t i) {
            for (std::size_t p = 0; p < pixels; ++p)
                (*aov.values)[aov.count * p + i] = packed[4 * p + component];
        });
        visit_ids(layout, a, [&](std::size_t component, int shift) {
            for (std::size_t p = 0; p < pixels; ++p) {
                const auto half = static_cast<std::uint32_t>(packed[4 * p + component]);
                aovs.instances[p] = shift == 0 ? half : aovs.instances[p] | half << shift;
            }
        });
    }
}

// Writes AOVs into attachments.
void pack(const Aovs& aovs, const AovLayout& layout, gl::RenderTarget& attachments) {
    const std::size_t pixels = static_cast<std::size_t>(aovs.width) * static_cast<std::size_t>(aovs.height);
    for (int a = 0; a < attachments.colours(); ++a) {
        std::vector<float> packed(4 * pixels);
        visit_floats(layout, a, aovs, [&](std::size_t component, const auto& aov, std::size_t i) {
            for (std::size_t p = 0; p < pixels; ++p)
                packed[4 * p + component] = (*aov.values)[aov.count * p + i];
        });
        visit_ids(layout, a, [&](std::size_t component, int shift) {
            for (std::size_t p = 0; p < pixels; ++p)
                packed[4 * p + component] = static_cast<float>(aovs.instances[p] >> shift & 0xffff);
        });
        attachments.write(a, packed);
    }
}

void check_size(const gl::Context& context, int width, int height) {
    const int most = context.limits().target_size;
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
}

}  // namespace

Framebuffer::Framebuffer(std::shared_ptr<gl::Context> context, int width, int height, int channels)
    : context_(std::move(context)), mutex_(context_), width_(width), height_(height), channels_(channels) {
    check_size(*context_, width, height);
    context_->run([this] {
        for (int first = 0; first < channels_; first += kGroup) {
            groups_.emplace_back(
                context_,
                gl::RenderTargetDescription{
                    .width = width_, .height = height_, .colours = std::min(kGroup, channels_ - first)});
        }
    });
}

Framebuffer::Framebuffer(std::shared_ptr<gl::Context> context, std::span<const unsigned> textures)
    : context_(std::move(context)),
      mutex_(context_),
      width_(0),
      height_(0),
      channels_(static_cast<int>(textures.size())),
      borrows_(true) {
    std::vector<gl::Texture2D> images;
    for (std::size_t i = 0; i < textures.size(); ++i) {
        if (std::ranges::find(textures.first(i), textures[i]) != textures.first(i).end())
            throw Error(ErrorCode::invalid_argument,
                        "the texture " + std::to_string(textures[i]) + " is given for two channels");
        images.push_back(gl::Texture2D::borrowed(context_, textures[i]));
        if (images.back().width() != images[0].width() || images.back().height() != images[0].height())
            throw Error(ErrorCode::invalid_argument, "the texture " + std::to_string(textures[i]) +
                                                         " has another size than the texture " +
                                                         std::to_string(textures[0]));
    }
    width_ = images.at(0).width();
    height_ = images[0].height();
    check_size(*context_, width_, height_);
    for (std::size_t first = 0; first < images.size(); first += kGroup) {
        const auto begin = images.begin() + static_cast<std::ptrdiff_t>(first);
        const auto end =
            images.begin() + static_cast<std::ptrdiff_t>(std::min(first + kGroup, images.size()));
        groups_.emplace_back(
            std::vector<gl::Texture2D>(std::make_move_iterator(begin), std::make_move_iterator(end)));
    }
}

std::vector<gl::RenderTarget>& Framebuffer::groups() {
    if (!on_device_) upload();
    return groups_;
}

void Framebuffer::upload() {
    const std::size_t plane = image_.data.size() / static_cast<std::size_t>(channels_);
    context_->run([&] {
        for (int c = 0; c < channels_; ++c) {
            groups_[static_cast<std::size_t>(c / kGroup)].write(
                c % kGroup,
                std::span<const float>(image_.data).subspan(static_cast<std::size_t>(c) * plane, plane));
        }
    });
    on_device_ = true;
}

const StokesImage& Framebuffer::image() {
    if (!has_image_) {
        const Stopwatch watch;
        if (image_.data.empty()) image_ = StokesImage(width_, height_, channels_);
        const std::size_t plane = image_.data.size() / static_cast<std::size_t>(channels_);
        context_->run([&] {
            for (int c = 0; c < channels_; ++c) {
                groups_[static_cast<std::size_t>(c / kGroup)].read(
                    c % kGroup, std::span(image_.data).subspan(static_cast<std::size_t>(c) * plane, plane));
            }
        });
        has_image_ = true;
        statistics_.observe_ms += watch.milliseconds();
    }
    return image_;
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

Framebuffer::DrawnAov Framebuffer::drawn_aov(AovBit aov) {
    if (!aov_attachments_) {
        const std::uint32_t drawn = aov_mask_ & ~std::uint32_t{aov_variance};
        std::shared_ptr<gl::RenderTarget> attachments = aov_attachments(drawn);
        pack(aovs(), AovLayout(drawn), *attachments);
        aovs_drawn_ = drawn;
        aov_attachments_ = std::move(attachments);
    }
    return {aov_attachments_.get(), AovLayout(aovs_drawn_).first(aov)};
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
    rendered(image, statistics);
    drew_aovs(aovs.mask(), 0, nullptr);
    aovs_ = std::move(aovs);
    // A host may read its textures at any time.
    if (context_->info().backend == gl::Backend::host) upload();
}

void Framebuffer::exchange(Framebuffer& other) {
    std::swap(groups_, other.groups_);
    std::swap(image_, other.image_);
    std::swap(has_image_, other.has_image_);
    std::swap(on_device_, other.on_device_);
    std::swap(aov_mask_, other.aov_mask_);
    std::swap(aovs_drawn_, other.aovs_drawn_);
    std::swap(aov_attachments_, other.aov_attachments_);
    std::swap(aovs_, other.aovs_);
    std::swap(statistics_, other.statistics_);
    std::swap(content_, other.content_);
}

void Framebuffer::rendered(const Statistics& statistics) {
    new_content(statistics);
    has_image_ = false;
}

void Framebuffer::rendered(StokesImage& image, const Statistics& statistics) {
    std::swap(image_, image);
    has_image_ = true;
    on_device_ = false;
    new_content(statistics);
}

void Framebuffer::new_content(const Statistics& statistics) {
    static std::atomic<std::uint64_t> contents = 0;
    content_ = ++contents;
    statistics_ = statistics;
}

}  // namespace nicol
