// SPDX-License-Identifier: MIT
// Light of equirectangular images.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include "error.hpp"
#include "light/environment_checks.hpp"
#include "light/equirect_projection.hpp"
#include "light/image_light.hpp"

namespace nicol {
namespace {

class ImageEnvironment final : public Environment {
public:
    ImageEnvironment(const EquirectView& from, double scale, const ImageContents& contents,
                     std::vector<double> wavelengths)
        : width_(from.width),
          height_(from.height),
          channels_(from.channels),
          components_(contents.linear || contents.circular ? 4 : 1),
          circular_(contents.circular),
          negative_(contents.negative),
          wavelengths_(std::move(wavelengths)),
          values_(std::make_unique_for_overwrite<float[]>(size())) {
        tbb::parallel_for(0, height_, [&](int y) {
            for (int c = 0; c < channels_; ++c) copy_row(from, scale, c, y);
        });
        const std::span all(values_.get(), size());
        dark_ = std::ranges::all_of(all, [](float value) { return value == 0; });
    }

    int channels() const noexcept override { return channels_; }
    bool polarized() const noexcept override { return components_ == 4; }
    bool circular() const noexcept override { return circular_; }
    bool dark() const noexcept override { return dark_; }
    const std::vector<double>& wavelengths() const noexcept override { return wavelengths_; }
    double negative_share() const noexcept override { return negative_; }

    Stokes radiance(int channel, const glm::dvec3& towards_light) const override {
        check_look_up(*this, channel, towards_light);
        return look_up(pixels(), channel, towards_light);
    }

    PshVector project(int order) const override {
        check_projection_order(order);
        return project_equirect(pixels(), order);
    }

    EquirectImage image() const override {
        EquirectImage image(width_, height_, channels_);
        image.wavelengths = wavelengths_;
        if (components_ == 4)
            std::copy_n(values_.get(), size(), image.data.begin());
        else
            for (std::size_t i = 0; i < size(); ++i) image.data[4 * i] = values_[i];
        return image;
    }

    EquirectView pixels() const noexcept override {
        const auto pixel = static_cast<std::size_t>(components_);
        const std::size_t row = pixel * static_cast<std::size_t>(width_);
        return {.width = width_,
                .height = height_,
                .channels = channels_,
                .components = components_,
                .values = values_.get(),
                .channel_stride = row * static_cast<std::size_t>(height_),
                .row_stride = row,
                .pixel_stride = pixel};
    }

private:
    [[nodiscard]] std::size_t size() const {
        return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) *
               static_cast<std::size_t>(channels_) * static_cast<std::size_t>(components_);
    }
    [[nodiscard]] std::size_t offset(int channel, int y, int x) const {
        const auto row = static_cast<std::size_t>(channel) * static_cast<std::size_t>(height_) +
                         static_cast<std::size_t>(y);
        return (row * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(components_);
    }

    void copy_row(const EquirectView& view, double scale, int channel, int y) {
        const float* from = view.values + static_cast<std::size_t>(channel) * view.channel_stride +
                            static_cast<std::size_t>(y) * view.row_stride;
        float* to = values_.get() + offset(channel, y, 0);
        for (int x = 0; x < width_; ++x, from += view.pixel_stride, to += components_) {
            for (int p = 0; p < components_; ++p) to[p] = static_cast<float>(scale * from[p]);
            to[0] = std::max(to[0], 0.0F);
        }
    }

    int width_, height_, channels_, components_;
    bool circular_;
    double negative_;
    bool dark_ = false;
    std::vector<double> wavelengths_;
    std::unique_ptr<float[]> values_;
};

void check_view(const EquirectView& view) {
    const auto invalid = [](const std::string& what) {
        throw Error(ErrorCode::invalid_argument, "view: " + what);
    };
    if (view.components != 1 && view.components != 4)
        invalid("components is " + std::to_string(view.components) + "; it must be 1 or 4");
    if (view.values == nullptr) invalid("values is null");
    const bool in_range = view.width >= 1 && view.height >= 1 && view.width <= kMaxImageSide &&
                          view.height <= kMaxImageSide && view.channels >= 1;
    if (!in_range ||
        static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height) > kMaxImagePixels)
        invalid(std::to_string(view.width) + " x " + std::to_string(view.height) + " pixels in " +
                std::to_string(view.channels) + " channels; an image has at most " +
                std::to_string(kMaxImageSide) + " a side, " + std::to_string(kMaxImagePixels) +
                " in all, and at least one channel");
}

}  // namespace

EquirectView view_of(const StokesImage& image) {
    const std::size_t row = 4 * static_cast<std::size_t>(image.width);
    return {.width = image.width,
            .height = image.height,
            .channels = image.channels,
            .components = 4,
            .values = image.data.data(),
            .channel_stride = row * static_cast<std::size_t>(image.height),
            .row_stride = row,
            .pixel_stride = 4};
}

EnvironmentPtr checked_environment(const EquirectView& view, std::vector<double> wavelengths, double scale,
                                   const std::string& name, ErrorCode code, double negative) {
    check_scale(name, scale);
    ImageContents contents = examine_equirect(view, scale, name, code);
    contents.negative = std::max(contents.negative, negative);
    return std::make_shared<ImageEnvironment>(view, scale, contents, std::move(wavelengths));
}

EnvironmentPtr image_environment(const EquirectImage& image, double scale) {
    image.check("image_environment: image");
    return checked_environment(view_of(image), image.wavelengths, scale, "image_environment",
                               ErrorCode::invalid_argument);
}

EnvironmentPtr image_environment(const EquirectView& view, double scale) {
    check_view(view);
    return checked_environment(view, {}, scale, "image_environment", ErrorCode::invalid_argument);
}

PshVector project_image(const EquirectView& view, int order) {
    check_view(view);
    check_projection_order(order);
    const ImageContents contents = examine_equirect(view, 1, "project_image", ErrorCode::invalid_argument);
    if (contents.negative == 0) return project_equirect(view, order);
    return ImageEnvironment(view, 1, contents, {}).project(order);
}

}  // namespace nicol
