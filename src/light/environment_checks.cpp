// SPDX-License-Identifier: MIT
// Checks of arguments of environments.
#include "light/environment_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <glm/geometric.hpp>

#include "error.hpp"

namespace nicol {

void check_look_up(const Environment& environment, int channel, const glm::dvec3& direction) {
    if (channel < 0 || channel >= environment.channels())
        throw Error(ErrorCode::invalid_argument, "radiance: channel " + std::to_string(channel) +
                                                     "; the environment has channels 0 to " +
                                                     std::to_string(environment.channels() - 1));
    // The condition is written so that NaN fails too.
    if (!(std::abs(glm::dot(direction, direction) - 1) <= 2e-6))
        throw Error(ErrorCode::invalid_argument, "radiance: towards_light must have unit length");
}

void check_projection_order(int order) {
    if (order < 0 || order > kMaxOrder)
        throw Error(ErrorCode::invalid_argument, "project: order " + std::to_string(order) +
                                                     "; it must be 0 to " + std::to_string(kMaxOrder));
}

void check_radiance(const char* what, const std::vector<double>& radiance) {
    if (radiance.empty())
        throw Error(ErrorCode::invalid_argument, std::string(what) + ": radiance needs at least one channel");
    for (std::size_t c = 0; c < radiance.size(); ++c)
        if (!(radiance[c] >= 0) || std::isinf(radiance[c]))
            throw Error(ErrorCode::invalid_argument, std::string(what) + ": radiance of channel " +
                                                         std::to_string(c) + " must be finite and >= 0");
}

void check_wavelengths(const char* what, const std::vector<double>& wavelengths, int channels) {
    const bool valid =
        std::ranges::all_of(wavelengths, [](double nm) { return nm > 0 && std::isfinite(nm); });
    if (!valid || (!wavelengths.empty() && wavelengths.size() != static_cast<std::size_t>(channels)))
        throw Error(ErrorCode::invalid_argument,
                    std::string(what) + ": wavelengths must be empty or one finite value > 0 a channel");
}

void check_brightness(const PshVector& light, double scale) {
    for (const double coefficient : light.data())
        if (!(std::abs(coefficient * scale) <= kBrightestLight)) {
            char text[128];
            (void)std::snprintf(text, sizeof text, "%g times its scale %g", coefficient, scale);
            throw Error(ErrorCode::invalid_argument,
                        "the environment is too bright to be rendered: it has the coefficient " +
                            std::string(text) + "; at most 1e30 is possible");
        }
}

void check_scale(const std::string& what, double scale) {
    if (!(scale >= 0) || std::isinf(scale))
        throw Error(ErrorCode::invalid_argument, what + ": scale must be finite and >= 0");
}

}  // namespace nicol
