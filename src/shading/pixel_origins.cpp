// SPDX-License-Identifier: MIT
#include "shading/pixel_origins.hpp"

#include <glm/common.hpp>

namespace nicol {
namespace {

// Columns in an order that spreads the first ones.
constexpr std::array<std::size_t, PixelOrigins::kPlaces> kColumns{0, 8, 4, 12, 2, 10, 6, 14,
                                                                  1, 9, 5, 13, 3, 11, 7, 15};
constexpr std::array<std::size_t, PixelOrigins::kEven> kEvenColumns{0, 4, 2, 6, 1, 5, 3, 7};

// Returns a place of a lattice with one place in each row and column, from the middle of a pixel of side 1.
template <std::size_t count>
glm::vec2 lattice_place(const std::array<std::size_t, count>& columns, std::size_t rise, std::size_t place) {
    const std::size_t column = columns[place % count], row = rise * column % count;
    const glm::vec2 cell(static_cast<float>(column), static_cast<float>(row));
    return (cell + 0.5F) / static_cast<float>(count) - 0.5F;
}

}  // namespace

const LaneVectors& PixelOrigins::at(std::size_t place) {
    place %= kPlaces;
    return found(place, place, [](std::size_t p) { return lattice_place(kColumns, 7, p); });
}

const LaneVectors& PixelOrigins::even(std::size_t place) {
    place %= kEven;
    return found(kPlaces + place, place, [](std::size_t p) { return lattice_place(kEvenColumns, 3, p); });
}

const LaneVectors& PixelOrigins::found(std::size_t index, std::size_t place,
                                       glm::vec2 (*offset)(std::size_t place)) {
    LaneVectors& out = origins_[index];
    if ((found_ >> index & 1U) != 0) return out;
    found_ |= 1U << index;
    std::array<Corners, kLanes> triangles;
    std::array<glm::vec2, kLanes> at, middles;
    const std::size_t count = parts_.size();
    for (std::size_t i = 0; i < count; ++i) {
        triangles[i] = parts_[i].triangle;
        middles[i] = parts_[i].middle;
        at[i] = middles[i] + parts_[i].size * offset(place + parts_[i].pixel);
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
