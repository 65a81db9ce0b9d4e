// SPDX-License-Identifier: MIT
// Directions, coordinates and frames of equirectangular images.
#include "light/equirect.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace nicol {

using std::numbers::pi;

glm::dvec3 equirect_direction(double u, double v) {
    const double radius = std::sin(pi * v);
    return {radius * std::sin(2 * pi * u), std::cos(pi * v), -radius * std::cos(2 * pi * u)};
}

glm::dvec2 equirect_coordinates(const glm::dvec3& w) {
    // atan2 of the radius is used because acos(y) loses half of the digits near the poles.
    const double v = std::atan2(std::hypot(w.x, w.z), w.y) / pi;
    if (w.x == 0 && w.z == 0) return {0, v};
    const double u = std::atan2(w.x, -w.z) / (2 * pi);
    const double wrapped = u < 0 ? u + 1 : u;
    return {wrapped < 1 ? wrapped : 0, v};
}

Frame equirect_frame(double u, double v) {
    const glm::dvec3 z = -equirect_direction(u, v);
    const glm::dvec3 x(std::cos(2 * pi * u), 0, std::sin(2 * pi * u));
    return {x, glm::cross(z, x), z};
}

double pixel_solid_angle(int width, int height, int row) {
    const double step = pi / (height - 1);
    const bool pole = row == 0 || row == height - 1;
    // Integral of a tent function of the zenith angle, or half of one, times the sine of the angle.
    const double depth =
        pole ? 1 - std::sin(step) / step : std::sin(row * step) * 2 * (1 - std::cos(step)) / step;
    return 2 * pi / width * depth;
}

glm::dmat3 equirect_axes() {
    return {glm::dvec3(0, 0, -1), glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0)};
}

}  // namespace nicol
