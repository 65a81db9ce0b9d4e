// SPDX-License-Identifier: MIT
#include "visibility/bundle_cones.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "simd/dispatch.hpp"

namespace nicol {
namespace {

// Against rounding: of radii, relative to the distance, and of cosines.
constexpr float kSlack = 1e-4F;

// disturbed[b] = 1 where the angle between an axis and the unit vector is at most the sum of half the opening
// angle and an angle of this cosine and sine, which is below a right angle.
[[gnu::always_inline]] inline void mark_near(std::size_t count, const float* x, const float* y,
                                             const float* z, const float* cosine, const float* sine,
                                             const glm::vec3& to, float ball_cosine, float ball_sine,
                                             std::uint8_t* disturbed) {
    for (std::size_t b = 0; b < count; ++b) {
        const float along = x[b] * to.x + y[b] * to.y + z[b] * to.z;
        const bool near = along >= cosine[b] * ball_cosine - sine[b] * ball_sine - kSlack;
        disturbed[b] = static_cast<std::uint8_t>(disturbed[b] | (near ? 1 : 0));
    }
}

}  // namespace

BundleCones::BundleCones(const DirectionSet& directions) {
    for (const RayBundle& bundle : directions.bundles()) {
        const auto ray = [&bundle](std::size_t i) {
            return glm::dvec3(bundle.x[i], bundle.y[i], bundle.z[i]);
        };
        glm::dvec3 sum(0.0);
        for (std::size_t i = 0; i < RayBundle::kRays; ++i) sum += ray(i);
        const double length = glm::length(sum);
        const glm::dvec3 axis = length > 1e-6 ? sum / length : ray(0);
        double cosine = 1;
        for (std::size_t i = 0; i < RayBundle::kRays; ++i) cosine = std::min(cosine, glm::dot(axis, ray(i)));
        // A cone wider than a half sphere is the whole sphere.
        const bool wide = cosine <= 0;
        x_.push_back(static_cast<float>(axis.x));
        y_.push_back(static_cast<float>(axis.y));
        z_.push_back(static_cast<float>(axis.z));
        cosine_.push_back(wide ? -2.0F : static_cast<float>(cosine));
        sine_.push_back(wide ? 2.0F : static_cast<float>(std::sqrt(1 - cosine * cosine)));
    }
}

void BundleCones::mark(const glm::vec3& origin, const glm::vec3& normal, const Ball& ball,
                       std::span<std::uint8_t> disturbed) const {
    const glm::vec3 to = ball.centre - origin;
    const float distance = glm::length(to);
    const float radius = ball.radius + kSlack * (distance + ball.radius);
    if (glm::dot(normal, to) < -radius) return;  // wholly below the horizon
    if (!(radius < distance)) {
        std::ranges::fill(disturbed, std::uint8_t{1});
        return;
    }
    const float sine = radius / distance;
    dispatch<mark_near>(x_.size(), x_.data(), y_.data(), z_.data(), cosine_.data(), sine_.data(),
                        to / distance, std::sqrt(1 - sine * sine), sine, disturbed.data());
}

}  // namespace nicol
