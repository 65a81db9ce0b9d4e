// SPDX-License-Identifier: MIT
// Light from an equirectangular picture.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "light/environment_checks.hpp"
#include "light/equirect.hpp"
#include "light/equirect_projection.hpp"
#include "nicol/error.hpp"

namespace nicol {
namespace {

class ImageEnvironment final : public Environment {
public:
    /// values [channel][row][column][components], components 1 or 4.
    ImageEnvironment(const EquirectImage& size, std::vector<float> values, int components, bool circular)
        : width_(size.width),
          height_(size.height),
          channels_(size.channels),
          components_(components),
          circular_(circular),
          wavelengths_(size.wavelengths),
          values_(std::move(values)) {}

    int channels() const noexcept override { return channels_; }
    bool polarized() const noexcept override { return components_ == 4; }
    bool circular() const noexcept override { return circular_; }
    const std::vector<double>& wavelengths() const noexcept override { return wavelengths_; }

    Stokes radiance(int channel, const glm::dvec3& towards_light) const override {
        check_look_up(*this, channel, towards_light);
        const glm::dvec2 uv = equirect_coordinates(towards_light);
        const double column = uv.x * width_ - 0.5;
        const double row = uv.y * (height_ - 1);
        const int left = static_cast<int>(std::floor(column));
        const int top = std::min(static_cast<int>(row), height_ - 2);
        const double a = column - left;
        const double b = row - top;
        const int x0 = left < 0 ? width_ - 1 : left;
        const int x1 = left + 1 < width_ ? left + 1 : 0;
        const Stokes s = (1 - b) * ((1 - a) * pixel(channel, top, x0) + a * pixel(channel, top, x1)) +
                         b * ((1 - a) * pixel(channel, top + 1, x0) + a * pixel(channel, top + 1, x1));
        if (components_ == 1) return s;
        return turned(s, angle_between(equirect_frame(uv.x, uv.y), theta_phi_frame(-towards_light)));
    }

    PshVector project(int order) const override {
        check_projection_order(order);
        return project_equirect({width_, height_, channels_, components_, values_}, order);
    }

    EquirectImage picture() const override {
        EquirectImage image(width_, height_, channels_);
        image.wavelengths = wavelengths_;
        const auto step = static_cast<std::size_t>(components_);
        for (std::size_t i = 0; i * step < values_.size(); ++i)
            for (std::size_t p = 0; p < step; ++p) image.data[4 * i + p] = values_[i * step + p];
        return image;
    }

private:
    [[nodiscard]] Stokes pixel(int channel, int y, int x) const {
        const auto row = static_cast<std::size_t>(channel) * static_cast<std::size_t>(height_) +
                         static_cast<std::size_t>(y);
        const float* v =
            values_.data() + (row * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)) *
                                 static_cast<std::size_t>(components_);
        return components_ == 1 ? Stokes(v[0], 0, 0, 0) : Stokes(v[0], v[1], v[2], v[3]);
    }

    int width_, height_, channels_, components_;
    bool circular_;
    std::vector<double> wavelengths_;
    std::vector<float> values_;
};

}  // namespace

EnvironmentPtr checked_environment(EquirectImage image, double scale, const std::string& name,
                                   ErrorCode code) {
    check_scale(name, scale);
    for (float& v : image.data) v = static_cast<float>(scale * v);
    check_physical(image, name, code);

    bool linear = false;
    bool circular = false;
    for (std::size_t i = 0; i < image.data.size(); i += 4) {
        linear = linear || image.data[i + 1] != 0 || image.data[i + 2] != 0;
        circular = circular || image.data[i + 3] != 0;
    }
    if (linear || circular) {
        std::vector<float> values = std::move(image.data);
        return std::make_shared<ImageEnvironment>(image, std::move(values), 4, circular);
    }
    std::vector<float> values(image.data.size() / 4);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = image.data[4 * i];
    return std::make_shared<ImageEnvironment>(image, std::move(values), 1, false);
}

EnvironmentPtr image_environment(EquirectImage image, double scale) {
    image.check("image_environment: image");
    return checked_environment(std::move(image), scale, "image_environment", ErrorCode::invalid_argument);
}

}  // namespace nicol
