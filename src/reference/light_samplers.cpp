// SPDX-License-Identifier: MIT
#include "reference/light_samplers.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "light/equirect.hpp"
#include "polarization/stokes.hpp"

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

/// Samples x in [0, 1] with a density proportional to (1 - x) a + x b.
double linear_sample(double u, double a, double b) {
    if (!(a + b > 0)) return u;
    return u * (a + b) / (a + std::sqrt(std::lerp(a * a, b * b, u)));
}

/// Returns the index whose share of a cumulative sum contains x. x becomes the position inside this share.
std::size_t choose_index(const std::vector<double>& cumulative, double& x) {
    // The value stays below the last sum, so that an index without a share is never chosen.
    const double at = std::min(x * cumulative.back(), std::nextafter(cumulative.back(), 0.0));
    const auto found = std::upper_bound(cumulative.begin(), cumulative.end() - 1, at);
    const double before = found == cumulative.begin() ? 0 : *(found - 1);
    x = std::clamp((at - before) / (*found - before), 0.0, 1 - 1e-16);
    return static_cast<std::size_t>(found - cumulative.begin());
}

std::vector<double> cumulative_areas(const Mesh& mesh) {
    std::vector<double> areas;
    double sum = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
        sum += glm::length(glm::cross(b - a, c - a)) / 2;
        areas.push_back(sum);
    }
    return areas;
}

/// Returns the mean radiance over the surface and the channels.
double brightness(const Emission& emission) {
    const glm::vec4 mean = emission.texture != nullptr ? emission.texture->mean() : glm::vec4(1);
    double sum = 0;
    for (int c = 0; c < emission.channels(); ++c)
        sum += textured_value(emission.radiance, emission.texture, mean, c);
    return sum / emission.channels();
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

SkyDisc::SkyDisc(const LocalLight& light)
    : light_(&light),
      axes_(theta_phi_frame(-glm::normalize(glm::dvec3(light.to_world[2])))),
      sin_half_(std::sin(light.angular_radius / 2)) {
    const double sine = std::sin(light.angular_radius);
    per_irradiance_ = 1 / (pi * sine * sine);
}

glm::dvec3 SkyDisc::sample(const glm::dvec2& point) const {
    const double sin_half = sin_half_ * std::sqrt(point.x);
    const double sine = 2 * sin_half * std::sqrt(1 - sin_half * sin_half);
    const double phi = 2 * pi * point.y;
    return glm::normalize(
        axes_ * glm::dvec3(sine * std::cos(phi), sine * std::sin(phi), 1 - 2 * sin_half * sin_half));
}

double SkyDisc::pdf(const glm::dvec3& towards_light) const {
    // The chord of an angle is twice the sine of its half.
    if (glm::length(towards_light - axes_[2]) > 2 * sin_half_) return 0;
    return 1 / (4 * pi * sin_half_ * sin_half_);
}

double SkyDisc::radiance(int channel) const {
    return per_irradiance_ * textured_value(light_->value, nullptr, {}, channel);
}

AreaLightSampler::AreaLightSampler(std::span<const TracedSurface> surfaces) : densities_(surfaces.size(), 0) {
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
        const Emission* const emission = surfaces[s].emission;
        if (emission == nullptr) continue;
        AreaLight area_light{.surface = s, .areas = cumulative_areas(surfaces[s].mesh), .power = 0};
        if (area_light.areas.empty()) continue;
        area_light.power = brightness(*emission) * area_light.areas.back() * (emission->two_sided ? 2 : 1);
        if (!(area_light.power > 0)) continue;
        powers_.push_back(area_light.power + (powers_.empty() ? 0 : powers_.back()));
        area_lights_.push_back(std::move(area_light));
    }
    for (const AreaLight& area_light : area_lights_) {
        const double chance = area_lights_.size() > kFew ? area_light.power / powers_.back() : 1;
        densities_[area_light.surface] = chance / area_light.areas.back();
    }
}

std::size_t AreaLightSampler::samples() const noexcept {
    return area_lights_.size() > kFew ? 1 : area_lights_.size();
}

RayHit AreaLightSampler::sample(std::size_t index, glm::dvec2 point) const {
    const AreaLight& area_light =
        area_lights_[area_lights_.size() > kFew ? choose_index(powers_, point.x) : index];
    const auto triangle = static_cast<std::uint32_t>(choose_index(area_light.areas, point.x));
    const double root = std::sqrt(point.x);
    return {.surface = area_light.surface,
            .triangle = triangle,
            .distance = 0,
            .b1 = root * (1 - point.y),
            .b2 = root * point.y};
}

}  // namespace nicol
