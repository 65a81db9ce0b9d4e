// SPDX-License-Identifier: MIT
#include "image.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "common/handles.hpp"

namespace {

// Returns sqrt(mean of term(value index) / mean of s0^2) for each component.
template <class Term>
StokesErrors relative_roots(const Truth& truth, Term term) {
    const std::size_t pixels = truth.mask.size();
    std::array<double, 4> sums{};
    double power = 0;
    for (std::size_t i = 0; i < truth.first.stokes.size(); ++i) {
        if (!truth.mask[i / 4 % pixels]) continue;
        sums[i % 4] += term(i);
        if (i % 4 == 0) power += double{truth.first.stokes[i]} * double{truth.second.stokes[i]};
    }
    if (!(power > 0)) throw std::runtime_error("no light reaches the camera from an object");
    StokesErrors errors{};
    for (std::size_t p = 0; p < 4; ++p) errors[p] = std::sqrt(std::max(sums[p], 0.0) / power);
    return errors;
}

}  // namespace

Image read_image(nicol_framebuffer framebuffer, nicol_plane plane) {
    Image image;
    check(nicol_framebuffer_get_size(framebuffer, &image.width, &image.height, &image.channels));
    const std::size_t floats = std::size_t{4} * image.width * image.height;
    image.stokes.resize(floats * image.channels);
    for (std::uint32_t c = 0; c < image.channels; ++c) {
        check(nicol_framebuffer_read(framebuffer, plane, c, image.stokes.data() + c * floats, 0,
                                     floats * sizeof(float)));
    }
    return image;
}

std::vector<std::uint32_t> read_instances(nicol_framebuffer framebuffer, std::size_t pixels) {
    std::vector<std::uint32_t> ids(pixels);
    nicol_plane_buffer buffer = NICOL_PLANE_BUFFER_INIT;
    buffer.plane = NICOL_PLANE_INSTANCE;
    buffer.pixels = ids.data();
    buffer.byte_size = ids.size() * sizeof(std::uint32_t);
    check(nicol_framebuffer_read_plane(framebuffer, &buffer));
    return ids;
}

Image reduced(const Image& image, std::uint32_t side) {
    Image small{
        .width = image.width / side, .height = image.height / side, .channels = image.channels, .stokes = {}};
    small.stokes.resize(std::size_t{4} * small.width * small.height * small.channels);
    const float weight = 1.0F / static_cast<float>(side * side);
    for (std::size_t row = 0; row < std::size_t{small.channels} * small.height * side; ++row) {
        for (std::size_t column = 0; column < std::size_t{small.width} * side; ++column) {
            const float* from = &image.stokes[4 * (row * image.width + column)];
            float* to = &small.stokes[4 * (row / side * small.width + column / side)];
            for (std::size_t p = 0; p < 4; ++p) to[p] += weight * from[p];
        }
    }
    return small;
}

Mask eroded(const Mask& mask, std::uint32_t width, std::uint32_t height) {
    Mask out(mask.size(), 0);
    for (std::size_t y = 1; y + 1 < height; ++y) {
        for (std::size_t x = 1; x + 1 < width; ++x) {
            bool inside = true;
            for (std::size_t v = y - 1; v <= y + 1; ++v) {
                for (std::size_t u = x - 1; u <= x + 1; ++u) inside = inside && mask[v * width + u] != 0;
            }
            out[y * width + x] = inside ? 1 : 0;
        }
    }
    return out;
}

StokesErrors Truth::errors(const Image& image) const {
    return relative_roots(*this, [&](std::size_t i) {
        const double x = image.stokes[i];
        return (x - double{first.stokes[i]}) * (x - double{second.stokes[i]});
    });
}

StokesErrors Truth::noise() const {
    return relative_roots(*this, [&](std::size_t i) {
        const double difference = double{first.stokes[i]} - double{second.stokes[i]};
        return difference * difference / 2;
    });
}

StokesErrors Truth::estimated_noise() const {
    return relative_roots(*this, [&](std::size_t i) { return double{variance.stokes[i]}; });
}

Truth::Tails Truth::tails(const Image& image) const {
    std::vector<double> s0, linear;
    double power = 0;
    for (std::size_t i = 0; i < image.stokes.size(); i += 4) {
        if (!mask[i / 4 % mask.size()]) continue;
        const auto error = [&](std::size_t p) { return double{image.stokes[i + p]} - mean_at(i + p); };
        s0.push_back(std::abs(error(0)));
        linear.push_back(std::hypot(error(1), error(2)));
        power += mean_at(i) * mean_at(i);
    }
    if (!(power > 0)) throw std::runtime_error("no light reaches the camera from an object");
    const double unit = std::sqrt(power / static_cast<double>(s0.size()));
    const auto tail = [&](std::vector<double>& errors) {
        std::ranges::sort(errors);
        const auto at = [&](double part) {
            return errors[static_cast<std::size_t>(part * static_cast<double>(errors.size() - 1))] / unit;
        };
        return Tail{.percentile_95 = at(0.95), .percentile_99 = at(0.99), .largest = at(1)};
    };
    return {.s0 = tail(s0), .linear = tail(linear)};
}

Truth::PolarizationError Truth::polarization_error(const Image& image) const {
    const auto dolp = [](double s0, double s1, double s2) { return s0 > 0 ? std::hypot(s1, s2) / s0 : 0; };
    PolarizationError error;
    double largest = 0;
    double count = 0, light = 0, polarized_light = 0;
    std::vector<double> made;
    for (std::size_t i = 0; i < image.stokes.size(); i += 4) {
        if (!mask[i / 4 % mask.size()]) continue;
        const std::complex<double> true_linear(mean_at(i + 1), mean_at(i + 2));
        const std::complex<double> made_linear(image.stokes[i + 1], image.stokes[i + 2]);
        const double expected = dolp(mean_at(i), true_linear.real(), true_linear.imag());
        made.push_back(dolp(image.stokes[i], made_linear.real(), made_linear.imag()));
        largest = std::max(largest, expected);
        const double difference = std::abs(made.back() - expected);
        const double weight = std::max(mean_at(i), 0.0);
        error.dolp += difference;
        error.dolp_by_light += weight * difference;
        // The phase of s1 + i s2 is twice the angle.
        error.aolp += std::abs(true_linear) * std::abs(std::arg(made_linear * std::conj(true_linear))) / 2;
        if (image.stokes[i] < 0) error.negative += 1;
        count += 1;
        light += weight;
        polarized_light += std::abs(true_linear);
    }
    error.dolp /= count;
    error.dolp_by_light = light > 0 ? error.dolp_by_light / light : 0;
    error.aolp = polarized_light > 0 ? error.aolp / polarized_light * 180 / std::numbers::pi : 0;
    error.negative /= count;
    error.streaks =
        static_cast<double>(std::ranges::count_if(made, [&](double d) { return d > largest + 0.1; })) / count;
    return error;
}
