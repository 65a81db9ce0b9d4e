// SPDX-License-Identifier: MIT
// Lookups in maps of filtered light, in double precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "polarization/stokes.hpp"
#include "specular/lobe_map.hpp"

namespace nicol::test {

/// Returns the Stokes vector of a channel at a direction, bilinear between texels, in the frame with this x.
inline Stokes look_up(const LobeMap& map, int channel, const glm::dvec3& d, const glm::dvec3& x) {
    constexpr double pi = std::numbers::pi;
    const double phi = std::atan2(d.y, d.x);
    const double u = (phi < 0 ? phi + 2 * pi : phi) / (2 * pi) * map.columns();
    const double v = std::atan2(std::hypot(d.x, d.y), d.z) / pi * (map.rows() - 1);
    const auto left = std::min(static_cast<std::size_t>(u), static_cast<std::size_t>(map.columns() - 1));
    const auto top = std::min(static_cast<std::size_t>(v), static_cast<std::size_t>(map.rows() - 2));
    const double a = u - static_cast<double>(left);
    const double b = v - static_cast<double>(top);
    const auto layers = static_cast<std::size_t>(map.layers());
    const auto number = [&](std::size_t i) {
        const auto at = [&](std::size_t row, std::size_t column) {
            const std::size_t texel = row * (static_cast<std::size_t>(map.columns()) + 1) + column;
            return static_cast<double>(map.texels()[4 * layers * texel + i]);
        };
        return (1 - b) * ((1 - a) * at(top, left) + a * at(top, left + 1)) +
               b * ((1 - a) * at(top + 1, left) + a * at(top + 1, left + 1));
    };
    const auto c = static_cast<std::size_t>(channel);
    if (!map.polarized()) return {number(c), 0, 0, 0};
    const double xx = number(8 * c + 2);
    const double yy = number(8 * c + 3);
    const double xy = number(8 * c + 4);
    const double xz = number(8 * c + 5);
    const double yz = number(8 * c + 6);
    const glm::dmat3 tensor(xx, xy, xz, xy, yy, yz, xz, yz, -xx - yy);
    const glm::dvec3 y = glm::cross(d, x);
    return {number(8 * c), (glm::dot(x, tensor * x) - glm::dot(y, tensor * y)) / 2, glm::dot(x, tensor * y),
            number(8 * c + 1)};
}

}  // namespace nicol::test
