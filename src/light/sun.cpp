// SPDX-License-Identifier: MIT
#include "light/sun.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "image/color.hpp"
#include "light/turbid_sky.hpp"

namespace nicol {
namespace {

constexpr double kClearest = 1.7;
constexpr double kIlluminance = 128;  // klx
// CIE chromaticity of a black body of 5778 K.
constexpr double kX = 0.3263, kY = 0.3357;

struct Wavelength {
    double micrometres;
    double ozone;  // absorption per cm of ozone
};
// The wavelengths at which spectra stand for red, green and blue.
constexpr std::array kWavelengths{Wavelength{0.611, 0.120}, Wavelength{0.549, 0.085},
                                  Wavelength{0.464, 0.009}};

/// Returns how many times as much air light passes as from the zenith.
double air_mass(double height) {
    const double elevation = std::asin(std::min(height, 1.0)) * 180 / std::numbers::pi;
    return 1 / (height + 0.15 * std::pow(3.885 + elevation, -1.253));
}

double transmittance(const Wavelength& wavelength, double turbidity, double mass) {
    const double air = 0.008735 * std::pow(wavelength.micrometres, -4.08);
    const double haze = (0.04608 * turbidity - 0.04586) * std::pow(wavelength.micrometres, -1.3);
    const double ozone = wavelength.ozone * 0.35;
    return std::exp(-mass * (air + haze + ozone));
}

/// Returns a rotation that takes +z along a unit vector.
glm::dmat4 along(const glm::dvec3& z) {
    const glm::dvec3 across = std::abs(z.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(across, z));
    return {glm::dvec4(x, 0), glm::dvec4(glm::cross(z, x), 0), glm::dvec4(z, 0), glm::dvec4(0, 0, 0, 1)};
}

}  // namespace

LocalLight sun_of(const RayleighSky& sky) {
    const glm::dvec3 sun = unit_sun(sky);
    LocalLight light;
    light.kind = LocalLight::Kind::directional;
    light.angular_radius = glm::radians(0.27);
    light.to_world = along(-sun);
    light.value.assign(sky.radiance.size(), 0);
    if (sun.y <= 0) return light;
    const double turbidity = std::max(sky.turbidity, kClearest);
    const PerezSky perez(turbidity, std::acos(std::min(sun.y, 1.0)));
    const double beyond = kIlluminance * scale_to_mean_one(perez, sun);
    std::array<double, 3> rgb = linear_rgb(kX / kY, 1, (1 - kX - kY) / kY);
    double luminance = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        rgb[c] *= beyond * transmittance(kWavelengths[c], turbidity, air_mass(sun.y));
        luminance += static_cast<double>(kLuminance[c]) * rgb[c];
    }
    for (std::size_t c = 0; c < light.value.size(); ++c)
        light.value[c] = sky.radiance[c] * (light.value.size() == 3 ? rgb[c] : luminance);
    return light;
}

}  // namespace nicol
