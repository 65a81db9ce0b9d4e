// SPDX-License-Identifier: MIT
#include "image/observer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "arguments.hpp"
#include "error.hpp"
#include "image/color.hpp"

namespace nicol {
namespace {

constexpr const char* kFrameText =
    "Stokes frame: x image right, y image up, z from the scene to the camera; angles counter-clockwise from "
    "x";

double finite(double v) {
    return std::isfinite(v) ? v : 0.0;
}

void check_channel(const StokesImage& image, int channel, const char* what) {
    image.check(what);
    if (channel != kMeanChannel && (channel < 0 || channel >= image.channels))
        throw Error(ErrorCode::invalid_argument, std::string(what) + ": channel " + std::to_string(channel) +
                                                     "; the observation has channels 0 to " +
                                                     std::to_string(image.channels - 1) +
                                                     ", and -1 is their mean");
}

/// Stokes vectors of an image row by row, of one channel or the mean of all channels.
class PixelReader {
public:
    PixelReader(const StokesImage& image, int channel)
        : data_(image.data.data()),
          plane_(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)),
          first_(channel == kMeanChannel ? 0 : static_cast<std::size_t>(channel)),
          count_(channel == kMeanChannel ? static_cast<std::size_t>(image.channels) : 1) {}

    [[nodiscard]] std::size_t size() const { return plane_; }
    [[nodiscard]] Stokes operator[](std::size_t pixel) const {
        Stokes sum(0);
        for (std::size_t c = first_; c < first_ + count_; ++c)
            for (std::size_t p = 0; p < 4; ++p)
                sum[static_cast<int>(p)] += finite(data_[(c * plane_ + pixel) * 4 + p]);
        return sum / static_cast<double>(count_);
    }

private:
    const float* data_;
    std::size_t plane_, first_, count_;
};

double dolp_of(const Stokes& s) {
    return s[0] > 0 ? std::min(std::hypot(s[1], s[2]) / s[0], 1.0) : 0.0;
}

double aolp_of(const Stokes& s) {
    if (s[0] <= 0 || (s[1] == 0 && s[2] == 0)) return 0.0;
    // The sum with 0.0 turns s2 = -0 into 0, because atan2 would give -pi/2 for vertical polarization.
    const double angle = 0.5 * std::atan2(s[2] + 0.0, s[1]);
    return angle <= -std::numbers::pi / 2 ? std::numbers::pi / 2 : angle;
}

std::uint8_t code(double unit_value) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(unit_value, 0.0, 1.0)));
}

double srgb_curve(double v) {
    if (v >= 1) return 1;  // the formula rounds to less
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

std::string number_text(double v) {
    std::array<char, 32> text{};
    static_cast<void>(std::snprintf(text.data(), text.size(), "%.9g", v));
    return text.data();
}

std::string channel_text(const StokesImage& image, int channel) {
    if (image.channels == 1) return "the only channel";
    return channel == kMeanChannel ? "mean of all channels" : "channel " + std::to_string(channel);
}

Observation blank(const StokesImage& image, const std::string& title, const std::string& observer,
                  const std::string& scale) {
    Observation observation;
    observation.width = image.width;
    observation.height = image.height;
    observation.rgb.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                           3);
    observation.text = {
        {"Title", title}, {"Nicol:Observer", observer}, {"Nicol:Scale", scale}, {"Nicol:Frame", kFrameText}};
    return observation;
}

/// Returns the colour with this hue, as a fraction of the circle (0 red, 1/3 green, 2/3 blue), saturation and
/// value, all in 0 to 1.
std::array<double, 3> hsv(double hue, double saturation, double value) {
    std::array<double, 3> rgb{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double shifted = 6 * hue + std::array<double, 3>{0, 4, 2}[i];
        const double distance = std::abs(shifted - 6 * std::floor(shifted / 6) - 3);
        rgb[i] = value * (1 - saturation + saturation * std::clamp(distance - 1, 0.0, 1.0));
    }
    return rgb;
}

}  // namespace

Observation tone_mapped(const StokesImage& image, double exposure) {
    image.check("tone_mapped: image");
    if (image.channels != 1 && image.channels != 3)
        throw Error(ErrorCode::invalid_argument, "tone_mapped: image has " + std::to_string(image.channels) +
                                                     " channels; it must have 1 (grey) or 3 (R G B)");
    if (!(std::abs(exposure) <= 1000))
        throw Error(ErrorCode::invalid_argument,
                    "tone_mapped: exposure must be a number of stops from -1000 to 1000");
    Observation observation = blank(image, "Radiance s0", "s0, sRGB curve, clipped",
                                    "1 in the image is " + number_text(std::exp2(-exposure)) + " in s0");
    observation.srgb = true;
    const double factor = std::exp2(exposure);
    for (std::size_t c = 0; c < 3; ++c) {
        const PixelReader pixels(image, image.channels == 1 ? 0 : static_cast<int>(c));
        for (std::size_t i = 0; i < pixels.size(); ++i)
            observation.rgb[3 * i + c] = code(srgb_curve(std::clamp(pixels[i][0] * factor, 0.0, 1.0)));
    }
    return observation;
}

Observation signed_component(const StokesImage& image, int component, double scale, int channel) {
    check_channel(image, channel, "signed_component");
    if (component < 0 || component > 3)
        throw Error(ErrorCode::invalid_argument,
                    "signed_component: component " + std::to_string(component) + "; it must be 0 to 3");
    if (!(scale >= 0) || std::isinf(scale))
        throw Error(ErrorCode::invalid_argument,
                    "signed_component: scale must be finite and > 0, or 0 for the largest absolute value");
    const PixelReader pixels(image, channel);
    const bool automatic = scale == 0;
    if (automatic) {
        for (std::size_t i = 0; i < pixels.size(); ++i)
            scale = std::max(scale, std::abs(pixels[i][component]));
        if (scale == 0) scale = 1;
    }
    const std::string name = std::string("s").append(std::to_string(component));
    Observation observation =
        blank(image, "Stokes component " + name,
              name + ", red negative, green positive, linear, " + channel_text(image, channel),
              "code 255 is |" + name + "| = " + number_text(scale) +
                  (automatic ? " (largest of the observation)" : " (given)"));
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const double value = pixels[i][component] / scale;
        observation.rgb[3 * i + (value < 0 ? 0 : 1)] = code(std::abs(value));
    }
    return observation;
}

Plane dolp(const StokesImage& image, int channel) {
    check_channel(image, channel, "dolp");
    const PixelReader pixels(image, channel);
    Plane plane{image.width, image.height, std::vector<float>(pixels.size())};
    for (std::size_t i = 0; i < pixels.size(); ++i) plane.values[i] = static_cast<float>(dolp_of(pixels[i]));
    return plane;
}

Observation dolp_image(const StokesImage& image, int channel) {
    check_channel(image, channel, "dolp_image");
    const PixelReader pixels(image, channel);
    Observation observation =
        blank(image, "Degree of linear polarization",
              "DoLP, grey, sRGB curve, " + channel_text(image, channel), "code 255 is DoLP = 1");
    observation.srgb = true;
    for (std::size_t i = 0; i < pixels.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) observation.rgb[3 * i + c] = code(srgb_curve(dolp_of(pixels[i])));
    return observation;
}

Plane aolp(const StokesImage& image, int channel) {
    check_channel(image, channel, "aolp");
    const PixelReader pixels(image, channel);
    Plane plane{image.width, image.height, std::vector<float>(pixels.size())};
    for (std::size_t i = 0; i < pixels.size(); ++i) plane.values[i] = static_cast<float>(aolp_of(pixels[i]));
    return plane;
}

Observation aolp_image(const StokesImage& image, AolpStyle style, int channel) {
    check_channel(image, channel, "aolp_image");
    std::string carrier;
    switch (style) {
        case AolpStyle::light:
            carrier = "saturation is DoLP";
            break;
        case AolpStyle::dark:
            carrier = "value is DoLP, sRGB curve";
            break;
        case AolpStyle::full:
            carrier = "black where DoLP < 1e-6";
            break;
        default:
            throw Error(ErrorCode::invalid_argument, "aolp_image: style must be light, dark or full");
    }
    const PixelReader pixels(image, channel);
    Observation observation = blank(image, "Angle of linear polarization",
                                    "AoLP, hue = AoLP / pi (0 red, +45 yellow-green, 90 cyan, -45 violet), " +
                                        carrier + ", " + channel_text(image, channel),
                                    "the full colour wheel is 180 degrees");
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const Stokes s = pixels[i];
        const double degree = dolp_of(s);
        const double hue = aolp_of(s) / std::numbers::pi;
        std::array<double, 3> rgb{};
        if (style == AolpStyle::light) rgb = hsv(hue, degree, 1);
        if (style == AolpStyle::dark) rgb = hsv(hue, 1, srgb_curve(degree));
        if (style == AolpStyle::full && degree >= 1e-6) rgb = hsv(hue, 1, 1);
        for (std::size_t c = 0; c < 3; ++c) observation.rgb[3 * i + c] = code(rgb[c]);
    }
    return observation;
}

Plane behind_polarizer(const StokesImage& image, double angle, int channel) {
    check_channel(image, channel, "behind_polarizer");
    if (!std::isfinite(angle))
        throw Error(ErrorCode::invalid_argument,
                    "behind_polarizer: angle must be a finite number of radians");
    const double c = std::cos(2 * angle);
    const double s = std::sin(2 * angle);
    const PixelReader pixels(image, channel);
    Plane plane{image.width, image.height, std::vector<float>(pixels.size())};
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const Stokes stokes = pixels[i];
        plane.values[i] = static_cast<float>(0.5 * (stokes[0] + c * stokes[1] + s * stokes[2]));
    }
    return plane;
}

StokesImage through_polarizer(const StokesImage& image, double angle) {
    image.check("through_polarizer: image");
    if (!std::isfinite(angle))
        throw Error(ErrorCode::invalid_argument,
                    "through_polarizer: angle must be a finite number of radians");
    const double c = std::cos(2 * angle);
    const double s = std::sin(2 * angle);
    StokesImage result(image.width, image.height, image.channels);
    result.wavelengths = image.wavelengths;
    for (std::size_t i = 0; i < image.data.size(); i += 4) {
        const double passed =
            0.5 * (finite(image.data[i]) + c * finite(image.data[i + 1]) + s * finite(image.data[i + 2]));
        result.data[i] = static_cast<float>(passed);
        result.data[i + 1] = static_cast<float>(c * passed);
        result.data[i + 2] = static_cast<float>(s * passed);
    }
    return result;
}

StokesImage luminance(const StokesImage& rgb) {
    rgb.check("luminance: image");
    require(rgb.channels == 3, "luminance: the image must have three channels");
    StokesImage grey(rgb.width, rgb.height, 1);
    const std::size_t plane = grey.data.size();
    for (std::size_t i = 0; i < plane; ++i) {
        grey.data[i] = kLuminance[0] * rgb.data[i] + kLuminance[1] * rgb.data[plane + i] +
                       kLuminance[2] * rgb.data[2 * plane + i];
    }
    return grey;
}

PngImage png_of(const Observation& observation) {
    return {.width = observation.width,
            .height = observation.height,
            .bytes = observation.rgb,
            .text = observation.text,
            .srgb = observation.srgb};
}

}  // namespace nicol
