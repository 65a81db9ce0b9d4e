// SPDX-License-Identifier: MIT
// Hazy sky as an image: Perez's radiance, Rayleigh's polarization, and a ground below.
#include "light/turbid_sky.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "image/color.hpp"
#include "light/equirect.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

constexpr int kWidth = 1024;
constexpr int kHeight = kWidth / 2 + 1;
constexpr int kHorizonRow = kHeight / 2;

/// Returns the solid angle of a pixel of row y above the horizon. The horizon's row counts half.
double solid_angle(int y) {
    const double step = pi / (kHeight - 1);
    return 2 * pi / kWidth * step * std::sin(y * step) * (y == kHorizonRow ? 0.5 : 1.0);
}

/// Returns (1 + A exp(B / cos z)) (1 + C exp(D g) + E cos^2 g).
double perez(const std::array<double, 5>& k, double cos_zenith, double gamma) {
    const double cosine = std::cos(gamma);
    return (1 + k[0] * std::exp(k[1] / cos_zenith)) *
           (1 + k[2] * std::exp(k[3] * gamma) + k[4] * cosine * cosine);
}

/// Coefficients of the zenith's chromaticity: rows T^2, T, 1; columns z^3, z^2, z, 1.
using ZenithTable = std::array<std::array<double, 4>, 3>;
constexpr ZenithTable kZenithX = {{{0.00166, -0.00375, 0.00209, 0},
                                   {-0.02903, 0.06377, -0.03202, 0.00394},
                                   {0.11693, -0.21196, 0.06052, 0.25886}}};
constexpr ZenithTable kZenithY = {{{0.00275, -0.00610, 0.00317, 0},
                                   {-0.04214, 0.08970, -0.04153, 0.00516},
                                   {0.15346, -0.26756, 0.06670, 0.26688}}};

double zenith_chromaticity(const ZenithTable& table, double turbidity, double z) {
    double result = 0;
    for (const auto& row : table)
        result = result * turbidity + ((row[0] * z + row[1]) * z + row[2]) * z + row[3];
    return result;
}

/// Returns PerezSky::at() of a direction on or above the horizon.
std::array<double, 3> color_at(const PerezSky& perez, const glm::dvec3& sun, const glm::dvec3& view) {
    // Perez's formula divides by this cosine, so the limit stands for the horizon itself.
    const double height = std::max(view.y, 1e-4);
    return perez.at(height, std::atan2(glm::length(glm::cross(sun, view)), glm::dot(sun, view)));
}

Frame frame_of(int x, int y) {
    return equirect_frame((x + 0.5) / kWidth, y / (kHeight - 1.0));
}

}  // namespace

PerezSky::PerezSky(double t, double sun_zenith)
    : shape_{{{0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251, 0.1206 * t - 2.5771,
               -0.0670 * t + 0.3703},
              {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125, -0.0641 * t - 0.8989,
               -0.0033 * t + 0.0452},
              {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102, -0.0441 * t - 1.6537,
               -0.0109 * t + 0.0529}}} {
    const double chi = (4.0 / 9 - t / 120) * (std::numbers::pi - 2 * sun_zenith);
    factor_ = {(4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192,
               zenith_chromaticity(kZenithX, t, sun_zenith), zenith_chromaticity(kZenithY, t, sun_zenith)};
    for (std::size_t i = 0; i < 3; ++i) factor_[i] /= perez(shape_[i], 1, sun_zenith);
}

std::array<double, 3> PerezSky::at(double cos_zenith, double gamma) const {
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = factor_[i] * perez(shape_[i], cos_zenith, gamma);
    return result;
}

std::array<double, 3> linear_srgb(const std::array<double, 3>& c) {
    const double x = c[0] * c[1] / c[2];
    const double y = c[0];
    const double z = c[0] * (1 - c[1] - c[2]) / c[2];
    return linear_rgb(x, y, z);
}

double scale_to_mean_one(const PerezSky& perez, const glm::dvec3& sun) {
    double luminance = 0;
    for (int y = 0; y <= kHorizonRow; ++y)
        for (int x = 0; x < kWidth; ++x)
            luminance += color_at(perez, sun, -frame_of(x, y)[2])[0] * solid_angle(y);
    return 2 * pi / luminance;
}

EquirectImage turbid_sky_image(const RayleighSky& sky, const glm::dvec3& sun) {
    const int channels = static_cast<int>(sky.radiance.size());
    const PerezSky perez(sky.turbidity, std::acos(std::clamp(sun.y, 0.0, 1.0)));
    EquirectImage image(kWidth, kHeight, channels);
    double luminance = 0;
    for (int y = 0; y <= kHorizonRow; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const Frame frame = frame_of(x, y);
            const glm::dvec3 view = -frame[2];
            const glm::dvec3 e = glm::cross(sun, view);
            const double cosine = glm::dot(sun, view);
            const std::array<double, 3> color = color_at(perez, sun, view);
            const std::array<double, 3> rgb = linear_srgb(color);
            luminance += color[0] * solid_angle(y);

            // DoLP = dop_max sin^2 / (1 + cos^2) along sun x view is computed without angles, so that it is
            // smooth at the sun.
            const double degree = sky.dop_max / (1 + cosine * cosine);
            const double ex = glm::dot(e, frame[0]);
            const double ey = glm::dot(e, frame[1]);
            const Stokes unit(1, degree * (ex * ex - ey * ey), degree * 2 * ex * ey, 0);
            for (int c = 0; c < channels; ++c) {
                const double value = channels == 3 ? rgb[static_cast<std::size_t>(c)] : color[0];
                for (std::size_t p = 0; p < 4; ++p)
                    image.at(c, y, x)[p] =
                        static_cast<float>(std::max(value, 0.0) * unit[static_cast<glm::length_t>(p)]);
            }
        }
    }
    for (int c = 0; c < channels; ++c) {
        // The scale gives a mean luminance of 1 over the upper half, times this channel's radiance.
        const double scale = sky.radiance[static_cast<std::size_t>(c)] * 2 * pi / luminance;
        double irradiance = 0;
        for (int y = 0; y <= kHorizonRow; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                for (float& value : image.at(c, y, x)) value = static_cast<float>(scale * value);
                irradiance += image.at(c, y, x)[0] * std::cos(y * pi / (kHeight - 1)) * solid_angle(y);
            }
        }
        const double albedo =
            sky.ground_albedo[sky.ground_albedo.size() == 1 ? 0 : static_cast<std::size_t>(c)];
        for (int y = kHorizonRow + 1; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                image.at(c, y, x)[0] = static_cast<float>(albedo / pi * irradiance);
    }
    return image;
}

}  // namespace nicol
