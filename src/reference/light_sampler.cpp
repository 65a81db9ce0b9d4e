// SPDX-License-Identifier: MIT
#include "reference/light_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "light/equirect.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

struct Choice {
    int index;
    double rest;  ///< position inside the chosen share, 0..1
};

Choice choose(std::span<const double> cumulative, double u) {
    const double wanted = u * cumulative.back();
    const auto found = std::upper_bound(cumulative.begin(), cumulative.end() - 1, wanted);
    const double before = found == cumulative.begin() ? 0 : *(found - 1);
    const double share = *found - before;
    return {static_cast<int>(found - cumulative.begin()),
            share > 0 ? std::clamp((wanted - before) / share, 0.0, 1.0) : 0.5};
}

/// x in [0, 1] with density proportional to (1 - x) a + x b.
double linear_sample(double u, double a, double b) {
    if (!(a + b > 0)) return u;
    return u * (a + b) / (a + std::sqrt(std::lerp(a * a, b * b, u)));
}

}  // namespace

LightSampler::LightSampler(const Environment& environment) {
    const EquirectImage image = environment.image();
    width_ = image.width;
    height_ = image.height;
    const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    values_.resize(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        for (int c = 0; c < image.channels; ++c) {
            const float s0 = image.data[4 * (static_cast<std::size_t>(c) * pixels + i)];
            values_[i] += std::abs(s0) / static_cast<float>(image.channels);
        }
    }

    cells_.reserve(pixels - static_cast<std::size_t>(width_));
    for (int row = 0; row + 1 < height_; ++row) {
        const double solid_angle = 4 * pi / width_ * (depth(row + 1) - depth(row));
        double sum = 0;
        for (int column = 0; column < width_; ++column) {
            const Corners c = corners(row, column);
            sum += (c.ul + c.ur + c.ll + c.lr) / 4 * solid_angle;
            cells_.push_back(sum);
        }
        total_ += sum;
        rows_.push_back(total_);
    }
}

double LightSampler::depth(int row) const {
    const double s = std::sin(pi / 2 * row / (height_ - 1));
    return s * s;
}

LightSampler::Corners LightSampler::corners(int row, int column) const {
    const float* upper = values_.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
    const float* lower = upper + width_;
    const int right = column + 1 < width_ ? column + 1 : 0;
    return {upper[column], upper[right], lower[column], lower[right]};
}

LightSample LightSampler::sample(const glm::dvec2& point) const {
    const Choice row = choose(rows_, point.y);
    const auto width = static_cast<std::size_t>(width_);
    const Choice column =
        choose(std::span(cells_).subspan(static_cast<std::size_t>(row.index) * width, width), point.x);
    const Corners c = corners(row.index, column.index);
    const double b = linear_sample(row.rest, c.ul + c.ur, c.ll + c.lr);
    const double left = std::lerp(c.ul, c.ll, b);
    const double right = std::lerp(c.ur, c.lr, b);
    const double a = linear_sample(column.rest, left, right);

    const double h = std::lerp(depth(row.index), depth(row.index + 1), b);
    const double radius = 2 * std::sqrt(h * (1 - h));
    const double azimuth = 2 * pi * (column.index + 0.5 + a) / width_;
    return {.towards_light = {radius * std::sin(azimuth), 1 - 2 * h, -radius * std::cos(azimuth)},
            .pdf = std::lerp(left, right, a) / total_};
}

double LightSampler::pdf(const glm::dvec3& towards_light) const {
    if (dark()) return 0;
    const glm::dvec2 uv = equirect_coordinates(towards_light);
    const double x = uv.x * width_ - 0.5;
    const int left = static_cast<int>(std::floor(x));
    const int row = std::min(static_cast<int>(uv.y * (height_ - 1)), height_ - 2);
    const double half = std::sin(pi / 2 * uv.y);
    const double b = std::clamp((half * half - depth(row)) / (depth(row + 1) - depth(row)), 0.0, 1.0);
    const Corners c = corners(row, left < 0 ? width_ - 1 : left);
    return std::lerp(std::lerp(c.ul, c.ll, b), std::lerp(c.ur, c.lr, b), x - left) / total_;
}

}  // namespace nicol
