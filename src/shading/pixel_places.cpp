// SPDX-License-Identifier: MIT
#include "shading/pixel_places.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace nicol {
namespace {

// Distance of a light from the mirrored direction, in widths of the lobe, beyond which the lobe hardly
// changes within a pixel.
constexpr float kHighlight = 4;
constexpr float kMostAcross = 6;

}  // namespace

glm::vec2 MirroredParts::middle(std::size_t part) {
    const std::size_t column = part % kAcross, row = part / kAcross;
    const glm::vec2 place(static_cast<float>(column), static_cast<float>(row));
    return (place + 0.5F) / static_cast<float>(kAcross) - 0.5F;
}

std::size_t MirroredParts::at(const glm::vec2& place) {
    const glm::vec2 part = glm::clamp((place + 0.5F) * static_cast<float>(kAcross), 0.0F, kAcross - 1.0F);
    return static_cast<std::size_t>(part.y) * kAcross + static_cast<std::size_t>(part.x);
}

PixelPlaces::PixelPlaces(const MirroredPixels& pixels, std::size_t count,
                         std::span<const MirroredParts> parts, const LaneVectors& mirrored)
    : pixels_(pixels), count_(count), parts_(parts) {
    for (std::size_t i = 0; i < count; ++i) {
        const MirroredPixel pixel = pixels.at(i);
        put(middles_, i, vector_at(mirrored, i) + pixel.shift);
        sides_[i] = std::max(glm::length(pixel.steps[0]), glm::length(pixel.steps[1]));
    }
}

std::uint32_t PixelPlaces::across(const LaneLight& light, double lobe_width, std::uint32_t samples) const {
    if (lobe_width >= kWidestLobe) return 0;
    const auto width = static_cast<float>(2 * lobe_width);  // a facet's turn counts twice
    float most = 0;
    bool near = false;
    for (std::size_t i = 0; i < count_; ++i) {
        const float away = glm::length(vector_at(middles_, i) - vector_at(light.towards, i));
        if (!(away < sides_[i] + kHighlight * width)) continue;
        near = true;
        most = std::max(most, sides_[i]);
    }
    if (!near) return 0;
    if (!parts_.empty()) {
        // Light samples of four in a row are at other quarters of each place: together they meet every part.
        const std::uint32_t places = samples < 4 ? 1 : 2;
        return static_cast<std::uint32_t>(MirroredParts::kAcross) / places;
    }
    const float wanted = std::min(most / width, kMostAcross) / std::sqrt(static_cast<float>(samples));
    return static_cast<std::uint32_t>(std::max(1.0F, std::ceil(wanted)));
}

void PixelPlaces::move(const LaneVectors& towards, const LaneVectors& x, const glm::vec2& place,
                       LaneLight& out) const {
    for (std::size_t i = 0; i < count_; ++i) {
        const glm::vec3 seen = seen_at(i, place);
        const glm::vec3 moved = glm::normalize(vector_at(towards, i) - seen);
        const glm::vec3 axis = vector_at(x, i);
        put(out.towards, i, moved);
        put(out.x, i, glm::normalize(axis - glm::dot(axis, moved) * moved));
    }
}

glm::vec3 PixelPlaces::seen_at(std::size_t i, const glm::vec2& place) const {
    if (!parts_.empty()) return parts_[i].from[MirroredParts::at(place)];
    const MirroredPixel pixel = pixels_.at(i);
    return pixel.shift + place.x * pixel.steps[0] + place.y * pixel.steps[1];
}

}  // namespace nicol
