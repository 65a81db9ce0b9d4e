// SPDX-License-Identifier: MIT
// Highlights of lights that are averaged over what a pixel shows.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>

#include "light/lane_light.hpp"
#include "shading/reflected_nodes.hpp"

namespace nicol {

/// Places within the pixels of up to sixteen points. Each place sees another direction mirrored, which may
/// change faster from pixel to pixel than a narrow lobe is wide. In the axes of the lights.
class PixelPlaces {
public:
    /// No places: points cover nothing.
    PixelPlaces() = default;
    /// pixels: not empty; must outlive this object. mirrored: the directions that the points mirror to the
    /// viewer. lobe_width: the narrowest of the material.
    PixelPlaces(std::span<const MirroredPixel> pixels, const LaneVectors& mirrored, float lobe_width);

    /// Returns the number of places along each side of the pixels that a light sample needs so that no lobe
    /// fits between the places of all `samples`: 0 if no point is near the light's highlight.
    [[nodiscard]] std::uint32_t across(const LaneLight& light, std::uint32_t samples) const;

    /// Sets the light's directions, and the x axes of its frames, to `towards` and `x`, moved so that the
    /// points reflect the light as they do at a place of their pixels. place: from the pixel's middle, -0.5
    /// to 0.5 to the right and down.
    void move(const LaneVectors& towards, const LaneVectors& x, const glm::vec2& place, LaneLight& out) const;

private:
    LaneVectors mirrored_{};
    std::span<const MirroredPixel> pixels_;
    float width_ = 1;  // of directions that the narrowest lobe reflects
};

}  // namespace nicol
