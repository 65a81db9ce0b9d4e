// SPDX-License-Identifier: MIT
#include "shading/shadow_rays.hpp"

#include <bit>
#include <cmath>

namespace nicol {

ShadowRays::ShadowRays(const RayScene& scene, const GlassShadows* glass, const LaneVectors& points,
                       const LaneVectors& origins)
    : scene_(scene), glass_(glass) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        lifts_.x[i] = origins.x[i] - points.x[i];
        lifts_.y[i] = origins.y[i] - points.y[i];
        lifts_.z[i] = origins.z[i] - points.z[i];
    }
    packet_.origin_x = origins.x.value;
    packet_.origin_y = origins.y.value;
    packet_.origin_z = origins.z.value;
}

std::uint32_t ShadowRays::visible(LaneLight& light, std::uint32_t points) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float nearness = 1 / light.distance[i];  // 0 for distant lights
        const float x = light.towards.x[i] - nearness * lifts_.x[i];
        const float y = light.towards.y[i] - nearness * lifts_.y[i];
        const float z = light.towards.z[i] - nearness * lifts_.z[i];
        const float length = std::sqrt(x * x + y * y + z * z);
        packet_.direction_x[i] = x / length;
        packet_.direction_y[i] = y / length;
        packet_.direction_z[i] = z / length;
        packet_.farthest[i] = light.distance[i] * length;
    }
    const std::uint32_t visible = traced(points);
    if (glass_ != nullptr && visible != 0) glass_->dim(packet_, visible, light);
    return visible;
}

std::uint32_t ShadowRays::visible_from_origins(const LaneLight& light, std::uint32_t points) {
    packet_.direction_x = light.towards.x.value;
    packet_.direction_y = light.towards.y.value;
    packet_.direction_z = light.towards.z.value;
    packet_.farthest = light.distance.value;
    return traced(points);
}

std::uint32_t ShadowRays::traced(std::uint32_t points) {
    count_ += static_cast<std::uint64_t>(std::popcount(points));
    return points & ~std::uint32_t{scene_.occluded(packet_, static_cast<std::uint16_t>(points))};
}

std::uint32_t LightShadows::reached(LaneLight& light, std::uint32_t points) {
    if (rays_ == nullptr || points == 0) return points;
    if (traced_ >= probes_ && seen_ != hidden_ && !rays_->through_glass()) return seen_ ? points : 0;
    ++traced_;
    const std::uint32_t visible = rays_->visible(light, points);
    seen_ = seen_ || visible != 0;
    hidden_ = hidden_ || visible != points;
    return visible;
}

}  // namespace nicol
