// SPDX-License-Identifier: MIT
#include "shading/pixel_origins.hpp"

#include <glm/common.hpp>

namespace nicol {
namespace {

// Returns a place, from the middle of a pixel of side 1. The places form a lattice with one of them in each
// row and column, in an order that spreads the first ones.
glm::vec2 offset_of(std::size_t place) {
    static constexpr std::array<std::size_t, PixelOrigins::kPlaces> order{0, 8, 4, 12, 2, 10, 6, 14,
                                                                          1, 9, 5, 13, 3, 11, 7, 15};
    constexpr auto count = static_cast<float>(PixelOrigins::kPlaces);
    const std::size_t column = order[place % order.size()], row = 7 * column % order.size();
    return (glm::vec2(static_cast<float>(column), static_cast<float>(row)) + 0.5F) / count - 0.5F;
}

}  // namespace

const LaneVectors& PixelOrigins::at(std::size_t place) {
    place %= kPlaces;
    LaneVectors& out = origins_[place];
    if ((found_ >> place & 1U) != 0) return out;
    found_ |= 1U << place;
    std::array<Corners, kLanes> triangles;
    std::array<glm::vec2, kLanes> at, middles;
    const std::size_t count = parts_.size();
    for (std::size_t i = 0; i < count; ++i) {
        triangles[i] = parts_[i].triangle;
        middles[i] = parts_[i].middle;
        at[i] = middles[i] + parts_[i].size * offset_of(place + parts_[i].pixel);
    }
    // A place on an edge of its triangle may lie in another surface, so that places are moved inwards a
    // little.
    constexpr float inwards = 1.0F / 16;
    LaneSurface surface, middle;
    find_surface(view_, positions_, normals_, std::span(triangles).first(count),
                 std::span(middles).first(count), middle);
    find_surface(view_, positions_, normals_, std::span(triangles).first(count), std::span(at).first(count),
                 surface);
    for (std::size_t i = 0; i < kLanes; ++i)
        put(out, i,
            glm::mix(surface.positions[i], middle.positions[i], inwards) + parts_[i < count ? i : 0].lift);
    return out;
}

}  // namespace nicol
