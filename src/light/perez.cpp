// SPDX-License-Identifier: MIT
// Perez's formula for luminance and chromaticity.
#include "light/perez.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace nicol {
namespace {

/// (1 + A exp(B / cos z)) (1 + C exp(D g) + E cos^2 g)
double perez(const std::array<double, 5>& k, double cos_zenith, double gamma) {
    const double cosine = std::cos(gamma);
    return (1 + k[0] * std::exp(k[1] / cos_zenith)) *
           (1 + k[2] * std::exp(k[3] * gamma) + k[4] * cosine * cosine);
}

/// Rows T^2, T, 1; columns z^3, z^2, z, 1.
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
    return {3.2404542 * x - 1.5371385 * y - 0.4985314 * z, -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
            0.0556434 * x - 0.2040259 * y + 1.0572252 * z};
}

}  // namespace nicol
