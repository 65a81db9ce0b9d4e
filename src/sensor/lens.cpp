// SPDX-License-Identifier: MIT
#include "sensor/lens.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "sensor/noise.hpp"

namespace nicol {
namespace {

/// Returns the weights of a pixel and of those on one side of it, by distance; both sides sum to 1.
std::vector<double> blur_weights(double deviation) {
    std::vector<double> weights;
    for (int i = 0; i <= std::ceil(4 * deviation); ++i)
        weights.push_back(decay(i * i / (2 * deviation * deviation)));
    double sum = weights[0];
    for (std::size_t i = 1; i < weights.size(); ++i) sum += 2 * weights[i];
    for (double& weight : weights) weight /= sum;
    return weights;
}

/// Blurs each line of `count` Stokes vectors, `step` floats apart. Lines begin `line` floats apart.
void blur_lines(std::span<const float> from, std::span<float> to, const std::vector<double>& weights,
                std::size_t lines, std::size_t line, std::ptrdiff_t count, std::size_t step) {
    tbb::parallel_for(std::size_t{0}, lines, [&](std::size_t number) {
        const auto at = [&](std::ptrdiff_t i) {
            return number * line +
                   static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, count - 1)) * step;
        };
        for (std::ptrdiff_t i = 0; i < count; ++i)
            for (std::size_t p = 0; p < 4; ++p) {
                double sum = weights[0] * static_cast<double>(from[at(i) + p]);
                for (std::size_t k = 1; k < weights.size(); ++k) {
                    const auto distance = static_cast<std::ptrdiff_t>(k);
                    sum += weights[k] * (static_cast<double>(from[at(i - distance) + p]) +
                                         static_cast<double>(from[at(i + distance) + p]));
                }
                to[at(i) + p] = static_cast<float>(sum);
            }
    });
}

void blur(StokesImage& image, double deviation) {
    const std::vector<double> weights = blur_weights(deviation);
    const auto width = static_cast<std::size_t>(image.width);
    const auto height = static_cast<std::size_t>(image.height);
    std::vector<float> between(4 * width * height);
    for (std::size_t c = 0; c < static_cast<std::size_t>(image.channels); ++c) {
        const std::span<float> plane = std::span(image.data).subspan(c * between.size(), between.size());
        blur_lines(plane, between, weights, height, 4 * width, image.width, 4);
        blur_lines(between, plane, weights, width, 4, image.height, 4 * width);
    }
}

void darken_corners(StokesImage& image, double missing) {
    // The cosine's fourth power is 1 / (1 + tan^2)^2, and the tangent grows with the distance from the
    // middle.
    const double corner = 1 / std::sqrt(1 - missing) - 1;
    const double middle_x = (image.width - 1) / 2.0;
    const double middle_y = (image.height - 1) / 2.0;
    const double squared = std::max(middle_x * middle_x + middle_y * middle_y, 1.0);
    tbb::parallel_for(0, image.height, [&](int y) {
        for (int x = 0; x < image.width; ++x) {
            const double distance = (x - middle_x) * (x - middle_x) + (y - middle_y) * (y - middle_y);
            const double root = 1 + corner * (distance / squared);
            for (int c = 0; c < image.channels; ++c)
                for (float& component : image.at(c, y, x))
                    component = static_cast<float>(static_cast<double>(component) / (root * root));
        }
    });
}

}  // namespace

StokesImage through_lens(const Sensor& sensor, const StokesImage& light) {
    StokesImage image = light;
    if (sensor.blur > 0) blur(image, sensor.blur);
    if (sensor.vignetting > 0) darken_corners(image, sensor.vignetting);
    return image;
}

}  // namespace nicol
