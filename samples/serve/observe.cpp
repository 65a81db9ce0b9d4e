// SPDX-License-Identifier: MIT
#include "observe.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "common/handles.hpp"

namespace {

/// Number of steps, so large that at most one 8-bit code begins within a step.
constexpr std::size_t kTableSize = 4096;

template <class Real>
Real srgb_curve(Real v) {
    if (v >= 1) return 1;  // in single precision the formula rounds to less
    return v <= Real(0.0031308) ? Real(12.92) * v : Real(1.055) * std::pow(v, 1 / Real(2.4)) - Real(0.055);
}

/// Exact 8-bit code of linear values without branches: the code at the beginning of the table's step, or the
/// next one.
class SrgbCodes {
public:
    SrgbCodes() {
        for (std::size_t i = 0; i <= kTableSize; ++i)
            first_[i] =
                static_cast<std::uint8_t>(std::lround(255 * srgb_curve(static_cast<double>(i) / kTableSize)));
        for (std::size_t code = 0; code < 255; ++code) {
            const double s = (static_cast<double>(code) + 0.5) / 255;
            next_[code] = static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
        }
        next_[255] = 2;  // above all values
    }
    [[nodiscard]] std::uint8_t operator()(float linear) const {
        // NaN becomes 0.
        const float v = std::min(std::max(0.0f, linear), 1.0f);
        const std::uint8_t code = first_[static_cast<std::size_t>(v * static_cast<float>(kTableSize))];
        return static_cast<std::uint8_t>(code + (v >= next_[code] ? 1 : 0));
    }

private:
    std::array<std::uint8_t, kTableSize + 1> first_{};
    std::array<float, 256> next_{};  ///< value from which the next code is nearer
};

std::uint8_t code(float unit) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(unit, 0.0f, 1.0f)));
}

float finite(float v) {
    return std::isfinite(v) ? v : 0.0f;
}

/// Returns [row][column][channel][value].
std::vector<float> read(nicol_framebuffer framebuffer, nicol_plane plane, std::size_t floats) {
    std::vector<float> data(floats);
    nicol_plane_buffer to = NICOL_PLANE_BUFFER_INIT;
    to.plane = plane;
    to.format = NICOL_FORMAT_FLOAT32;
    to.channel = NICOL_ALL_CHANNELS;
    to.pixels = data.data();
    to.byte_size = floats * sizeof(float);
    check(nicol_framebuffer_read_plane(framebuffer, &to));
    return data;
}

/// Computes the angle and degree of the channels' mean.
void polarization(const std::vector<float>& stokes, std::uint32_t channels, std::vector<float>& into) {
    for (std::size_t i = 0; i < into.size() / 2; ++i) {
        std::array<float, 3> sum{};
        for (std::size_t c = 0; c < channels; ++c)
            for (std::size_t p = 0; p < 3; ++p) sum[p] += finite(stokes[(i * channels + c) * 4 + p]);
        const auto [s0, s1, s2] = sum;
        if (!(s0 > 0) || (s1 == 0 && s2 == 0)) continue;
        // Adding 0 removes the sign of s2 = -0, which would turn vertical polarization into -pi/2.
        const float angle = 0.5f * std::atan2(s2 + 0.0f, s1);
        constexpr auto right_angle = static_cast<float>(std::numbers::pi / 2);
        into[2 * i] = angle <= -right_angle ? right_angle : angle;
        into[2 * i + 1] = std::min(std::hypot(s1, s2) / s0, 1.0f);
    }
}

void hue(float angle, float value, std::uint8_t* rgb) {
    for (std::size_t i = 0; i < 3; ++i) {
        const float shifted = 6 * angle + std::array<float, 3>{0, 4, 2}[i];
        const float distance = std::abs(shifted - 6 * std::floor(shifted / 6) - 3);
        rgb[i] = code(value * std::clamp(distance - 1, 0.0f, 1.0f));
    }
}

float mean(const float* values, std::uint32_t count) {
    float sum = 0;
    for (std::uint32_t c = 0; c < count; ++c) sum += finite(values[c]);
    return sum / static_cast<float>(count);
}

}  // namespace

FloatImage observe(nicol_framebuffer framebuffer, const ImageRequest& request) {
    FloatImage image;
    std::uint32_t channels = 0;
    check(nicol_framebuffer_get_size(framebuffer, &image.width, &image.height, &channels));
    const std::size_t pixels = std::size_t{image.width} * image.height;
    const auto gain = static_cast<float>(std::exp2(request.exposure));
    const bool polar = request.observer == Observer::dolp || request.observer == Observer::aolp;
    if (!polar && request.observer != Observer::polarizer) {
        const auto plane = static_cast<nicol_plane>(request.observer);  // both begin with s0, s1, s2, s3
        image.values = channels;
        image.data = read(framebuffer, plane, pixels * channels);
        if (request.observer == Observer::s0 && gain != 1)
            for (float& value : image.data) value *= gain;
        return image;
    }
    const std::vector<float> stokes = read(framebuffer, NICOL_PLANE_STOKES, pixels * channels * 4);
    image.values = polar ? 2 : channels;
    image.data.resize(pixels * image.values);
    if (polar) {
        polarization(stokes, channels, image.data);
        return image;
    }
    const double angle = request.polarizer * std::numbers::pi / 180;
    const auto c = static_cast<float>(std::cos(2 * angle)), s = static_cast<float>(std::sin(2 * angle));
    for (std::size_t i = 0; i < image.data.size(); ++i) {
        const float* vector = stokes.data() + 4 * i;
        image.data[i] = gain * 0.5f * (finite(vector[0]) + c * finite(vector[1]) + s * finite(vector[2]));
    }
    return image;
}

std::vector<std::uint8_t> colours(const FloatImage& image, Observer observer, float& scale) {
    static const SrgbCodes srgb;
    const std::size_t pixels = std::size_t{image.width} * image.height;
    const std::uint32_t values = image.values;
    const float* data = image.data.data();
    std::vector<std::uint8_t> rgb(pixels * 3);
    if (observer == Observer::s0 || observer == Observer::polarizer) {
        if (values == 1)
            for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = srgb(data[i / 3]);
        else
            for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = srgb(data[i]);
    } else if (observer == Observer::dolp) {
        for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = srgb(data[i / 3 * 2 + 1]);
    } else if (observer == Observer::aolp) {
        for (std::size_t i = 0; i < pixels; ++i)
            hue(data[2 * i] / static_cast<float>(std::numbers::pi), srgb_curve(data[2 * i + 1]), &rgb[3 * i]);
    } else {
        std::vector<float> means(pixels);
        for (std::size_t i = 0; i < pixels; ++i) means[i] = mean(data + i * values, values);
        if (scale == 0) {
            for (const float value : means) scale = std::max(scale, std::abs(value));
            if (scale == 0) scale = 1;
        }
        for (std::size_t i = 0; i < pixels; ++i)
            rgb[3 * i + (means[i] < 0 ? 0 : 1)] = code(std::abs(means[i]) / scale);
    }
    return rgb;
}
