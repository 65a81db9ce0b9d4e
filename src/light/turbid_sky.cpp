// SPDX-License-Identifier: MIT
// A sky with haze, as an image: Perez's radiance, Rayleigh's polarization, and a ground below.
#include "light/turbid_sky.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "light/equirect.hpp"
#include "light/perez.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

constexpr int kWidth = 1024;
constexpr int kHeight = kWidth / 2 + 1;
constexpr int kHorizonRow = kHeight / 2;

/// Solid angle of a pixel of row y above the horizon; the horizon's row counts half.
double solid_angle(int y) {
    const double step = pi / (kHeight - 1);
    return 2 * pi / kWidth * step * std::sin(y * step) * (y == kHorizonRow ? 0.5 : 1.0);
}

}  // namespace

EquirectImage turbid_sky_image(const RayleighSky& sky, const glm::dvec3& sun) {
    const int channels = static_cast<int>(sky.radiance.size());
    const PerezSky perez(sky.turbidity, std::acos(std::clamp(sun.y, 0.0, 1.0)));
    EquirectImage image(kWidth, kHeight, channels);
    double luminance = 0;
    for (int y = 0; y <= kHorizonRow; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const Frame frame = equirect_frame((x + 0.5) / kWidth, y / (kHeight - 1.0));
            const glm::dvec3 view = -frame[2];
            const glm::dvec3 e = glm::cross(sun, view);
            const double cosine = glm::dot(sun, view);
            // At the horizon itself the limit of Perez's formula, which divides by this cosine.
            const double height = std::max(view.y, 1e-4);
            const std::array<double, 3> color = perez.at(height, std::atan2(glm::length(e), cosine));
            const std::array<double, 3> rgb = linear_srgb(color);
            luminance += color[0] * solid_angle(y);

            // DoLP = dop_max sin^2 / (1 + cos^2) along sun x view, computed without angles: smooth at the
            // sun.
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
        // To a mean luminance of 1 over the upper half, times this channel's radiance.
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
