// SPDX-License-Identifier: MIT
// Ideal, infinitely thin polarization elements.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <optional>
#include <string_view>

#include "polarization/mueller.hpp"

namespace nicol {

/// Largest size of an angle and of a retardance, in radians: a million degrees with room for rounding.
/// Floats keep the fraction of so many turns.
inline constexpr double kLargestElementAngle = 1.000001e6 * std::numbers::pi / 180;

/// Polarization element. Light passes through it in both directions with equal effect and without a change of
/// direction. In its local coordinates the element lies in the plane z = 0 about the origin.
struct PolarizationElement {
    enum class Kind { polarizer, retarder, right_circular, left_circular };
    enum class Outline {
        rectangle,  ///< |x| <= 1, |y| <= 1
        disk,       ///< radius 1
    };
    Kind kind = Kind::polarizer;
    Outline outline = Outline::rectangle;
    glm::dmat4 to_world{1.0};  ///< transform from local to world coordinates; affine and invertible
    /// Angle of a polarizer's transmission axis or a retarder's fast axis, in radians, from x towards y of
    /// PlacedElement, at most kLargestElementAngle in size. Circular polarizers ignore the angle.
    double angle = 0;
    /// Retardance of a retarder at normal incidence, in radians, at most kLargestElementAngle in size; pi/2
    /// is a quarter-wave plate.
    double retardance = std::numbers::pi / 2;
    double transmittance = 1;  ///< factor on the transmittance of the ideal element, 0 to 1
    bool operator==(const PolarizationElement&) const = default;
};

/// Throws Error(invalid_argument) that has the name unless a number is an angle of an element in radians.
void check_element_angle(double radians, std::string_view name);

/// Throws Error(invalid_argument) that names the member that is out of range. Does not check to_world.
void check(const PolarizationElement& element);

/// Point where a line meets an element.
struct ElementCrossing {
    double distance;   ///< in multiples of the line's direction
    glm::dvec2 place;  ///< x and y in the element's local coordinates
};

/// Polarization element in other coordinates, such as the world's. The frame of the element: z is the normal,
/// x the image of the element's local x, and y = z cross x.
class PlacedElement {
public:
    /// Places the element in the coordinates to which `from_world` transforms the world.
    explicit PlacedElement(const PolarizationElement& element,
                           const glm::dmat4& from_world = glm::dmat4(1.0));

    /// Returns where a line from `origin` meets the element; nothing if the line misses the element.
    [[nodiscard]] std::optional<ElementCrossing> crossing(const glm::dvec3& origin,
                                                          const glm::dvec3& direction) const;

    /// Returns the Mueller matrix for light in a frame whose z is the light's unit propagation. Oblique
    /// incidence follows Mitsuba 3: the effective axis is the component of axis() perpendicular to the ray,
    /// and the retardance is proportional to the cosine of incidence.
    [[nodiscard]] Mueller mueller(const Frame& received) const {
        return mueller(received, element_.angle, element_.retardance);
    }
    /// Returns the Mueller matrix that the element would have with this angle and retardance.
    [[nodiscard]] Mueller mueller(const Frame& received, double angle, double retardance) const;

    [[nodiscard]] const PolarizationElement& element() const noexcept { return element_; }
    [[nodiscard]] const glm::dvec3& center() const noexcept { return center_; }
    [[nodiscard]] const glm::dvec3& normal() const noexcept { return normal_; }  ///< unit vector
    /// Returns the transform to coordinates in which the outline is the one of the element's local
    /// coordinates and z is the height above the element.
    [[nodiscard]] const glm::dmat3& to_local() const noexcept { return to_local_; }
    /// Returns a unit vector in the element's plane: a polarizer's absorbing axis or a retarder's fast axis.
    [[nodiscard]] glm::dvec3 axis() const { return axis(element_.angle); }
    /// Returns the axis that the element would have with this angle.
    [[nodiscard]] glm::dvec3 axis(double angle) const;

private:
    PolarizationElement element_;
    glm::dvec3 center_;
    glm::dvec3 normal_;
    glm::dvec3 x_, y_;  // axes from which the angle of axis() is counted
    glm::dmat3 to_local_;
};

}  // namespace nicol
