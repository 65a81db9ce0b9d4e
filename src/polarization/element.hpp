// SPDX-License-Identifier: MIT
// Ideal, infinitely thin sheets that change the polarization of the light that passes through them.
#pragma once

#include <glm/mat4x4.hpp>
#include <numbers>
#include <optional>

#include "polarization/mueller.hpp"

namespace nicol {

/// Light passes both ways alike, without a change of direction. In its own axes an element lies in the plane
/// z = 0 about the origin.
struct PolarizationElement {
    enum class Kind { polarizer, retarder, right_circular, left_circular };
    enum class Outline {
        rectangle,  ///< |x| <= 1, |y| <= 1
        disk,       ///< of radius 1
    };
    Kind kind = Kind::polarizer;
    Outline outline = Outline::rectangle;
    glm::dmat4 to_world{1.0};  ///< affine and invertible
    /// Of the axis that a polarizer transmits, or of a retarder's fast axis: radians, from x towards y of
    /// PlacedElement. Circular ones have none.
    double angle = 0;
    /// Of a retarder, radians, where light passes at right angles; pi/2 is a quarter-wave plate.
    double retardance = std::numbers::pi / 2;
    double transmittance = 1;  ///< times what is ideal, 0 to 1
};

/// Throws Error(invalid_argument) naming the member that is out of range; not of to_world.
void check(const PolarizationElement& element);

/// An element in other axes, such as the world's. Its frame: z is the normal, x the image of the element's x,
/// and y = z cross x.
class PlacedElement {
public:
    /// `from_world` takes the world to these axes.
    explicit PlacedElement(const PolarizationElement& element,
                           const glm::dmat4& from_world = glm::dmat4(1.0));

    /// How many `direction`s from `origin` a line meets the element; nothing where it does not.
    [[nodiscard]] std::optional<double> distance(const glm::dvec3& origin, const glm::dvec3& direction) const;

    /// Of light in a frame whose z is its unit propagation. At oblique incidence as Mitsuba 3: a polarizer
    /// absorbs along what is across the ray of the axis that it absorbs, and the retardance is
    /// proportional to the cosine. A retarder's fast axis is what is across the ray of it.
    [[nodiscard]] Mueller mueller(const Frame& received) const;

    [[nodiscard]] const PolarizationElement& element() const noexcept { return element_; }
    [[nodiscard]] const glm::dvec3& center() const noexcept { return center_; }
    [[nodiscard]] const glm::dvec3& normal() const noexcept { return normal_; }  ///< unit
    /// To coordinates in which the outline is that of the element's own axes, and z is the height above it.
    [[nodiscard]] const glm::dmat3& to_local() const noexcept { return to_local_; }
    /// Unit, in the plane: that which absorbs, of polarizers, or is fast.
    [[nodiscard]] const glm::dvec3& axis() const noexcept { return axis_; }

private:
    PolarizationElement element_;
    glm::dvec3 center_;
    glm::dvec3 normal_;
    glm::dvec3 axis_;
    glm::dmat3 to_local_;
};

}  // namespace nicol
