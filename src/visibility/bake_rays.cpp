// SPDX-License-Identifier: MIT
#include "visibility/bake_rays.hpp"

#include <bit>
#include <cmath>
#include <numbers>

namespace nicol {
namespace {

// Returns the transmittance from which on rays in a direction pass. Directions follow a curve that fills the
// sphere, along which multiples of the golden ratio spread the thresholds evenly, in every part of it.
double threshold(std::size_t direction) {
    return std::fmod(0.5 + static_cast<double>(direction) / std::numbers::phi, 1.0);
}

}  // namespace

std::uint16_t BakeRays::occluded(const glm::vec3& origin, const RayBundle& bundle, const Numbers& numbers,
                                 std::uint16_t active) const {
    std::uint16_t out = blockers->occluded(origin, bundle, active);
    if (glass == nullptr) return out;
    const auto open = static_cast<std::uint16_t>(active & ~out);
    std::uint16_t through = glass->surfaces->occluded(origin, bundle, open);
    for (; through != 0; through = static_cast<std::uint16_t>(through & (through - 1))) {
        const auto i = static_cast<std::size_t>(std::countr_zero(through));
        const Ray ray{.origin = glm::dvec3(origin),
                      .direction = glm::dvec3(bundle.x[i], bundle.y[i], bundle.z[i])};
        if (glass->transmittance(ray) <= threshold(numbers[i]))
            out = static_cast<std::uint16_t>(out | 1U << i);
    }
    return out;
}

}  // namespace nicol
