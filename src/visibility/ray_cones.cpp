// SPDX-License-Identifier: MIT
#include "visibility/ray_cones.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "simd/dispatch.hpp"
#include "visibility/bundle_bits.hpp"

namespace nicol {
namespace {

// Margin of cosines against rounding.
constexpr float kCosineSlack = 1e-4F;
// Angle to the farthest directions beside one, in sides of the square that a direction has of the sphere.
constexpr float kBeside = 1.6F;

struct Cones {
    const float* x;
    const float* y;
    const float* z;
    const float* cosine;
    const float* sine;
};

// Sets near[b] to 1 if the angle between axis b and the unit vector `to` is at most the sum of two angles, or
// else to 0: half the bundle's opening angle, and an angle up to a right angle.
[[gnu::always_inline]] inline void find_near(std::size_t count, const Cones& cones, const glm::vec3& to,
                                             float cosine, float sine, std::uint8_t* near) {
    for (std::size_t b = 0; b < count; ++b) {
        const float along = cones.x[b] * to.x + cones.y[b] * to.y + cones.z[b] * to.z;
        near[b] = along >= cones.cosine[b] * cosine - cones.sine[b] * sine - kCosineSlack ? 1 : 0;
    }
}

}  // namespace

RayCones::RayCones(const DirectionSet& directions)
    : directions_(directions),
      beside_(kBeside * std::sqrt(4 * std::numbers::pi_v<float> / static_cast<float>(directions.size()))) {
    for (const RayBundle& bundle : directions.bundles()) add_bundle(bundle);
}

void RayCones::add_bundle(const RayBundle& bundle) {
    const auto ray = [&bundle](std::size_t i) { return glm::dvec3(bundle.x[i], bundle.y[i], bundle.z[i]); };
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < RayBundle::kRays; ++i) sum += ray(i);
    const double length = glm::length(sum);
    const glm::dvec3 axis = length > 1e-6 ? sum / length : ray(0);
    double cosine = 1;
    for (std::size_t i = 0; i < RayBundle::kRays; ++i) cosine = std::min(cosine, glm::dot(axis, ray(i)));
    // A cone wider than a half sphere is replaced by the whole sphere.
    const bool wide = cosine <= 0;
    x_.push_back(static_cast<float>(axis.x));
    y_.push_back(static_cast<float>(axis.y));
    z_.push_back(static_cast<float>(axis.z));
    cosine_.push_back(wide ? -2.0F : static_cast<float>(cosine));
    sine_.push_back(wide ? 2.0F : static_cast<float>(std::sqrt(1 - cosine * cosine)));
}

void RayCones::add(const glm::vec3& axis, float sine, std::span<std::uint16_t> bits) const {
    const float cosine = std::sqrt(1 - sine * sine);
    std::array<std::uint8_t, DirectionSet::kMost / RayBundle::kRays> near;  // set by find_near()
    const Cones cones{x_.data(), y_.data(), z_.data(), cosine_.data(), sine_.data()};
    dispatch<find_near>(bits.size(), cones, axis, cosine, sine, near.data());
    for (std::size_t b = 0; b < bits.size(); ++b) {
        if (near[b] == 0) continue;
        const std::uint16_t rays =
            dispatch<rays_above>(directions_.bundles()[b], axis, cosine - kCosineSlack);
        bits[b] = static_cast<std::uint16_t>(bits[b] | rays);
    }
}

void RayCones::find_above(const glm::vec3& normal, std::span<std::uint8_t> above) const {
    const Cones cones{x_.data(), y_.data(), z_.data(), cosine_.data(), sine_.data()};
    dispatch<find_near>(above.size(), cones, normal, 0.0F, 1.0F, above.data());
}

void RayCones::add_beside(std::size_t i, std::span<std::uint16_t> bits) const {
    add(directions_.directions()[i], beside_, bits);
}

}  // namespace nicol
