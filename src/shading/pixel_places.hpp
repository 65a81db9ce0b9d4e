// SPDX-License-Identifier: MIT
// Highlights of lights that are averaged over what a pixel shows.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "light/lane_light.hpp"
#include "shading/lane_surface.hpp"
#include "shading/reflected_nodes.hpp"

namespace nicol {

/// Parts of a pixel, row by row, with normals that a texture perturbs more finely than the pixel.
struct MirroredParts {
    static constexpr std::size_t kAcross = LaneSurface::kPartsAcross;
    static constexpr std::size_t kCount = kAcross * kAcross;
    std::array<glm::vec3, kCount> normals;  ///< unit shading normals
    /// From the direction that the normal mirrors at the shaded point to that at the part's middle.
    std::array<glm::vec3, kCount> from;

    /// Returns the place of a part's middle, from the pixel's middle: -0.5 to 0.5 to the right and down.
    [[nodiscard]] static glm::vec2 middle(std::size_t part);
    /// Returns the part at a place.
    [[nodiscard]] static std::size_t at(const glm::vec2& place);
};

/// Places within the pixels of up to sixteen points. Each place sees another direction mirrored, which may
/// change faster from pixel to pixel than a narrow lobe is wide. In the axes of the lights.
class PixelPlaces {
public:
    /// No places: points cover nothing.
    PixelPlaces() = default;
    /// count: number of points. parts: empty or one for each point; must outlive this object. mirrored: the
    /// directions that the points mirror to the viewer.
    PixelPlaces(const MirroredPixels& pixels, std::size_t count, std::span<const MirroredParts> parts,
                const LaneVectors& mirrored);

    /// Lobe width from which on lobes hardly change within a pixel.
    static constexpr double kWidestLobe = 0.3;

    /// Returns the number of places along each side of the pixels that a light sample needs so that no lobe
    /// fits between the places of all `samples`: 0 if no point is near the light's highlight. lobe_width: the
    /// narrowest of the terms that reflect the light.
    [[nodiscard]] std::uint32_t across(const LaneLight& light, double lobe_width,
                                       std::uint32_t samples) const;

    /// Sets the light's directions, and the x axes of its frames, to `towards` and `x`, moved so that the
    /// points reflect the light as they do at a place of their pixels, with the normals of the parts there.
    /// place: from the pixel's middle, -0.5 to 0.5 to the right and down.
    void move(const LaneVectors& towards, const LaneVectors& x, const glm::vec2& place, LaneLight& out) const;

private:
    // Returns the change of the direction that a point's pixel mirrors at a place, but for that of the
    // normal.
    [[nodiscard]] glm::vec3 seen_at(std::size_t i, const glm::vec2& place) const;

    LaneVectors middles_{};  // directions that the middles of the pixels mirror
    Lanes sides_{};          // longest change of the direction across each pixel
    MirroredPixels pixels_;
    std::size_t count_ = 0;
    std::span<const MirroredParts> parts_;
};

}  // namespace nicol
