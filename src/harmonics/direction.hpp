// SPDX-License-Identifier: MIT
// A direction as the quantities harmonics are computed from.
#pragma once

#include <complex>

#include <glm/vec3.hpp>

#include "harmonics/scaled.hpp"

namespace nicol {

/// Half-angle functions of theta and exp(i phi) without inverse functions, accurate next to both poles; phi
/// is 0 on the axis. Throws Error(invalid_argument) for a direction without one.
struct Polar {
    HalfAngle half;
    std::complex<double> phase;

    explicit Polar(const glm::dvec3& direction) {
        const double largest =
            std::fmax(std::abs(direction.x), std::fmax(std::abs(direction.y), std::abs(direction.z)));
        require(largest > 0 && std::isfinite(direction.x) && std::isfinite(direction.y) &&
                    std::isfinite(direction.z),
                "direction is zero or not finite");
        const double x = direction.x / largest;
        const double y = direction.y / largest;
        const double z = direction.z / largest;
        const double rho = std::hypot(x, y);
        const double length = std::hypot(rho, z);
        // The larger of the two by a square root, the smaller from their product sin(theta) / 2.
        const double large = std::sqrt((1 + std::abs(z) / length) / 2);
        const double small = rho / length / (2 * large);
        half = z >= 0 ? HalfAngle{small, large} : HalfAngle{large, small};
        phase = rho > 0 ? std::complex(x / rho, y / rho) : std::complex(1.0, 0.0);
    }
};

}  // namespace nicol
