// SPDX-License-Identifier: MIT
#include "shading/shadow_rays.hpp"

#include <bit>
#include <cmath>

#include "shading/light_changes.hpp"

namespace nicol {
namespace {

// Squared error of the lit fraction of a pixel by a few places, over that by as many random ones, because the
// places are spread over the pixel.
constexpr float kErrorOfPlaces = 0.4F;

}  // namespace

std::uint32_t ShadowRays::visible(LaneLight& light, std::uint32_t points, const LaneVectors& origins) {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float nearness = 1 / light.distance[i];  // 0 for distant lights
        const float x = light.towards.x[i] - nearness * (origins.x[i] - points_.x[i]);
        const float y = light.towards.y[i] - nearness * (origins.y[i] - points_.y[i]);
        const float z = light.towards.z[i] - nearness * (origins.z[i] - points_.z[i]);
        const float length = std::sqrt(x * x + y * y + z * z);
        packet_.direction_x[i] = x / length;
        packet_.direction_y[i] = y / length;
        packet_.direction_z[i] = z / length;
        packet_.farthest[i] = light.distance[i] * length;
    }
    const std::uint32_t visible = traced(origins, points);
    if (glass_ != nullptr && visible != 0) glass_->dim(packet_, visible, light);
    return visible;
}

std::uint32_t ShadowRays::visible_from_origins(const LaneLight& light, std::uint32_t points) {
    packet_.direction_x = light.towards.x.value;
    packet_.direction_y = light.towards.y.value;
    packet_.direction_z = light.towards.z.value;
    packet_.farthest = light.distance.value;
    return traced(origins_, points);
}

std::uint32_t ShadowRays::traced(const LaneVectors& origins, std::uint32_t points) {
    packet_.origin_x = origins.x.value;
    packet_.origin_y = origins.y.value;
    packet_.origin_z = origins.z.value;
    count_ += static_cast<std::uint64_t>(std::popcount(points));
    return points & ~std::uint32_t{scene_.occluded(packet_, static_cast<std::uint16_t>(points))};
}

std::uint32_t LightShadows::reached(LaneLight& light, std::uint32_t points) {
    // Numbers of samples say which part of the light they come from. The places follow another order, since
    // otherwise each place would meet one part of the light alone.
    return reached_from(&PixelOrigins::at, traced_ ^ traced_ >> 2, light, points);
}

std::uint32_t LightShadows::reached_from(Origins origins, std::size_t place, LaneLight& light,
                                         std::uint32_t points) {
    if (rays_ == nullptr || points == 0) return points;
    if (traced_ >= probes_ && seen_ != hidden_ && !rays_->through_glass()) return seen_ ? points : 0;
    const std::uint32_t found = places_ == nullptr
                                    ? rays_->visible(light, points)
                                    : rays_->visible(light, points, (places_->*origins)(place));
    ++traced_;
    seen_ = seen_ || found != 0;
    hidden_ = hidden_ || found != points;
    return found;
}

std::uint32_t LightShadows::reached_in_part(LaneLight& light, std::uint32_t points) {
    std::uint32_t found = reached_from(&PixelOrigins::even, 0, light, points);
    // Rays from other places would dim light by the same glass again.
    if (places_ == nullptr || found == 0 || found == points || rays_->through_glass()) return found;
    constexpr float share = 1.0F / PixelOrigins::kEven;
    Lanes fractions{};
    std::uint32_t out = 0;
    for (std::size_t place = 0; place < PixelOrigins::kEven; ++place) {
        if (place > 0) found = rays_->visible(light, points, places_->even(place));
        for (std::size_t i = 0; i < kLanes; ++i) fractions[i] += (found >> i & 1U) != 0 ? share : 0.0F;
        out |= found;
    }
    scale(fractions, light);
    doubtful_ = true;
    for (std::size_t i = 0; i < kLanes; ++i)
        doubts_[i] = fractions[i] > 0 ? kErrorOfPlaces * share * (1 - fractions[i]) / fractions[i] : 0.0F;
    return out;
}

}  // namespace nicol
