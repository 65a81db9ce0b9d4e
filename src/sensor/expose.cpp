// SPDX-License-Identifier: MIT
#include "sensor/expose.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "arguments.hpp"
#include "sensor/noise.hpp"

namespace nicol {
namespace {

/// Electrons beyond all full wells, which keep Poisson's quantile finite.
constexpr double kMostElectrons = 1e12;

void require_finite_light(const StokesImage& light) {
    const auto wrong = std::ranges::find_if(light.data, [](float v) { return !std::isfinite(v); });
    if (wrong == light.data.end()) return;
    const auto pixel = static_cast<std::size_t>(wrong - light.data.begin()) / 4;
    const auto width = static_cast<std::size_t>(light.width);
    const auto height = static_cast<std::size_t>(light.height);
    refuse("the light of channel " + std::to_string(pixel / (width * height)) + " at column " +
           std::to_string(pixel % width) + ", row " + std::to_string(pixel / width % height) +
           " is not finite");
}

/// Two normal numbers that belong to a pixel in every frame.
std::array<double, 2> pixel_errors(const Sensor& sensor, std::uint32_t pixel, NoiseOf purpose) {
    const std::array<double, 2> u = uniform_pair(sensor.seed, 0, pixel, purpose);
    return {normal_quantile(u[0]), normal_quantile(u[1])};
}

/// Sensitivity of a pixel to the Stokes vector in front of the optics: the first row of the Mueller matrices
/// of the pixel's polarizer times the optics.
class Analysers {
public:
    explicit Analysers(const Sensor& sensor) : sensor_(sensor) {}

    [[nodiscard]] Stokes at(int x, int y, std::uint32_t pixel) const {
        if (sensor_.mosaic == Mosaic::plain) return behind_optics({1, 0, 0, 0});
        double across = sensor_.extinction_ratio > 0 ? 1 / sensor_.extinction_ratio : 0;
        std::array<double, 2> turned{1, 0};
        if (sensor_.misalignment > 0 || sensor_.extinction_spread > 0) {
            const std::array<double, 2> error = pixel_errors(sensor_, pixel, NoiseOf::micro_polarizer);
            turned = cosine_and_sine(std::numbers::pi / 90 * sensor_.misalignment * error[0]);
            across = std::clamp(across * (1 + sensor_.extinction_spread * error[1]), 0.0, 1.0);
        }
        constexpr std::array<std::array<double, 2>, 4> axes{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
        const std::array<double, 2> axis = axes[angle_at(x, y)];
        const double half = (1 - across) / 2;
        return behind_optics({(1 + across) / 2, half * (axis[0] * turned[0] - axis[1] * turned[1]),
                              half * (axis[1] * turned[0] + axis[0] * turned[1]), 0});
    }

private:
    [[nodiscard]] Stokes behind_optics(const Stokes& row) const {
        Stokes product(0);
        for (int column = 0; column < 4; ++column)
            for (int i = 0; i < 4; ++i)
                product[column] +=
                    row[i] * sensor_.optics(static_cast<std::size_t>(i), static_cast<std::size_t>(column));
        return product;
    }

    const Sensor& sensor_;
};

/// Mean electrons of a pixel from light, before crosstalk.
double lit_electrons(const Sensor& sensor, const StokesImage& light, const Stokes& analyser, int x, int y) {
    const auto plane = static_cast<std::size_t>(light.width) * static_cast<std::size_t>(light.height);
    const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(light.width) + static_cast<std::size_t>(x);
    const auto channel_electrons = [&](std::size_t channel) {
        const float* const s = &light.data[4 * (channel * plane + pixel)];
        double sum = 0;
        for (int p = 0; p < 4; ++p) sum += analyser[p] * static_cast<double>(s[p]);
        return std::clamp(electrons_of(sensor, channel) * sum, 0.0, kMostElectrons);
    };
    if (sensor.mosaic == Mosaic::polarized_bayer) return channel_electrons(colour_at(x, y));
    double sum = 0;
    for (std::size_t c = 0; c < static_cast<std::size_t>(light.channels); ++c) sum += channel_electrons(c);
    return sum / light.channels;
}

/// Means of all pixels from light, with row-wise access to neighbours. Beyond the border a pixel is its own
/// neighbour, so that crosstalk loses no electrons.
class Means {
public:
    Means(const Sensor& sensor, const StokesImage& light)
        : width_(light.width), height_(light.height), crosstalk_(sensor.crosstalk) {
        values_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
        const Analysers analysers(sensor);
        tbb::parallel_for(0, height_, [&](int y) {
            for (int x = 0; x < width_; ++x) {
                const std::size_t i = index(x, y);
                const Stokes analyser = analysers.at(x, y, static_cast<std::uint32_t>(i));
                values_[i] = lit_electrons(sensor, light, analyser, x, y);
            }
        });
    }

    [[nodiscard]] double after_crosstalk(int x, int y) const {
        const double own = values_[index(x, y)];
        if (crosstalk_ == 0) return own;
        const double around =
            values_[index(std::max(x - 1, 0), y)] + values_[index(std::min(x + 1, width_ - 1), y)] +
            values_[index(x, std::max(y - 1, 0))] + values_[index(x, std::min(y + 1, height_ - 1))];
        return (1 - crosstalk_) * own + crosstalk_ / 4 * around;
    }
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

private:
    int width_, height_;
    double crosstalk_;
    std::vector<double> values_;
};

std::uint16_t number_of(const Sensor& sensor, double mean, std::uint32_t pixel, std::uint64_t frame) {
    double offset = 0;
    if (sensor.prnu > 0 || sensor.dsnu > 0) {
        const std::array<double, 2> error = pixel_errors(sensor, pixel, NoiseOf::response);
        mean = std::max(mean * (1 + sensor.prnu * error[0]), 0.0);
        offset = sensor.dsnu * error[1];
    }
    mean += sensor.dark_current * sensor.exposure_time;
    const std::array<double, 2> u = uniform_pair(sensor.seed, frame, pixel, NoiseOf::exposure);
    const double electrons =
        std::min(sensor.shot_noise ? poisson_quantile(u[0], mean) : mean, sensor.full_well);
    const double read = sensor.read_noise > 0 ? sensor.read_noise * normal_quantile(u[1]) : 0;
    const double number =
        std::floor(gain_of(sensor) * (electrons + read + offset) + sensor.black_level + 0.5);
    return static_cast<std::uint16_t>(std::clamp(number, 0.0, largest_number(sensor)));
}

}  // namespace

RawImage expose(const Sensor& sensor, const StokesImage& light, std::uint64_t frame) {
    light.check("light");
    check(sensor, light.width, light.height, light.channels);
    require_finite_light(light);
    const Means means(sensor, light);
    RawImage raw{light.width, light.height, {}};
    raw.values.resize(static_cast<std::size_t>(light.width) * static_cast<std::size_t>(light.height));
    tbb::parallel_for(0, light.height, [&](int y) {
        for (int x = 0; x < light.width; ++x) {
            const std::size_t i = means.index(x, y);
            raw.values[i] =
                number_of(sensor, means.after_crosstalk(x, y), static_cast<std::uint32_t>(i), frame);
        }
    });
    return raw;
}

}  // namespace nicol
