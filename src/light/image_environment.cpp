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
          values_(std::move(values)) {}

    int channels() const noexcept override { return channels_; }
    bool polarized() const noexcept override { return components_ == 4; }
    bool circular() const noexcept override { return circular_; }

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
    std::vector<float> values_;
};

/// Makes a picture physical, or throws Error(code) with `name` in front of every message.
class Validator {
public:
    Validator(EquirectImage& image, std::string name, ErrorCode code)
        : image_(image), name_(std::move(name)), code_(code) {}

    void run() const {
        if (image_.width < 2 || image_.height < 2)
            throw Error(code_, name_ + ": " + std::to_string(image_.width) + " x " +
                                   std::to_string(image_.height) +
                                   " pixels; an environment needs at least 2 x 2");
        const std::size_t plane = image_.data.size() / static_cast<std::size_t>(image_.channels);
        for (std::size_t first = 0; first < image_.data.size(); first += plane) check_plane(first, plane);
    }

private:
    void check_plane(std::size_t first, std::size_t plane) const {
        float* data = image_.data.data();
        float largest = 0;
        for (std::size_t i = first; i < first + plane; i += 4) {
            for (std::size_t p = 0; p < 4; ++p)
                if (!std::isfinite(data[i + p])) refuse(i, "is not finite");
            largest = std::max(largest, data[i]);
        }
        for (std::size_t i = first; i < first + plane; i += 4) {
            const double polarized = std::hypot(data[i + 1], data[i + 2], data[i + 3]);
            if (data[i] < 0) {
                // Colours outside the gamut of the file's primaries and lossy compression leave such values.
                if (polarized > 0 || data[i] < -0.1 * largest)
                    refuse(i, "has s0 < 0; radiance cannot be negative");
                data[i] = 0;
            }
            if (polarized > 1.01 * data[i] + 1e-3 * largest)
                refuse(i, "is polarized more than fully: sqrt(s1^2 + s2^2 + s3^2) exceeds s0");
        }
    }

    [[noreturn]] void refuse(std::size_t element, const std::string& what) const {
        const std::size_t pixel = element / 4;
        const auto width = static_cast<std::size_t>(image_.width);
        const auto height = static_cast<std::size_t>(image_.height);
        throw Error(code_, name_ + ": channel " + std::to_string(pixel / (width * height)) + ", pixel (" +
                               std::to_string(pixel % width) + ", " + std::to_string(pixel / width % height) +
                               ") " + what);
    }

    EquirectImage& image_;
    std::string name_;
    ErrorCode code_;
};

EnvironmentPtr make(EquirectImage image, double scale, const std::string& name, ErrorCode code) {
    if (!(scale >= 0) || std::isinf(scale))
        throw Error(ErrorCode::invalid_argument, name + ": scale must be finite and >= 0");
    for (float& v : image.data) v = static_cast<float>(scale * v);
    Validator(image, name, code).run();

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

}  // namespace

EnvironmentPtr load_environment(const std::filesystem::path& path, double scale) {
    EquirectImage image;
    static_cast<StokesImage&>(image) = read_exr(path);
    return make(std::move(image), scale, path.string(), ErrorCode::invalid_file);
}

EnvironmentPtr image_environment(EquirectImage image, double scale) {
    image.check("image_environment: image");
    return make(std::move(image), scale, "image_environment", ErrorCode::invalid_argument);
}

}  // namespace nicol
