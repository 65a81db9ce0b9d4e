// SPDX-License-Identifier: MIT
// Start points of shadow rays all over what pixels show.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "polarization/lane_points.hpp"
#include "shading/lane_surface.hpp"

namespace nicol {

/// Start points within the parts of pixels that sixteen points stand for. With them, the edge of a shadow
/// hides a fraction of a pixel's light. Start points are found when they are first asked for.
class PixelOrigins {
public:
    static constexpr std::size_t kPlaces = 16;  ///< number of places in a pixel, one in each 16th of a side
    static constexpr std::size_t kEven = 8;     ///< number of places whose mean is the middle of the pixel

    /// Part of a pixel that shows one surface.
    struct Part {
        Corners triangle;
        glm::vec2 middle;     ///< position on the image plane, see find_surface()
        glm::vec2 size;       ///< sides of the rectangle around the middle, on the image plane
        glm::vec3 lift;       ///< from the surface to the start points
        std::uint32_t pixel;  ///< index, row by row
    };
    /// Keeps references to the arguments, which must outlive the object. parts: at most kLanes.
    PixelOrigins(const Viewpoint& view, std::span<const glm::vec3> positions,
                 std::span<const glm::vec3> normals, std::span<const Part> parts)
        : view_(view), positions_(positions), normals_(normals), parts_(parts) {}

    /// Returns the start points at one of kPlaces places, which is another one in neighbouring pixels of a
    /// row, so that together they meet an edge of any direction. A place outside its triangle is moved
    /// inside.
    [[nodiscard]] const LaneVectors& at(std::size_t place);

    /// Returns the start points at one of kEven places, one in each eighth of a side: for a fraction of the
    /// pixel, where all of them are needed.
    [[nodiscard]] const LaneVectors& even(std::size_t place);

private:
    // Returns the points number `index` of origins_. offset: of a place from the middle of a pixel of side 1.
    const LaneVectors& found(std::size_t index, std::size_t place, glm::vec2 (*offset)(std::size_t place));

    std::array<LaneVectors, kPlaces + kEven> origins_;
    const Viewpoint& view_;
    std::span<const glm::vec3> positions_, normals_;
    std::span<const Part> parts_;
    std::uint32_t found_ = 0;  // bits of origins_
};

}  // namespace nicol
