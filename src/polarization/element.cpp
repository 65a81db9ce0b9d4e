// SPDX-License-Identifier: MIT
#include "polarization/element.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <string>

#include "arguments.hpp"

namespace nicol {
namespace {

/// Returns the Mueller matrix in the frame whose x is a polarizer's absorbing axis or a retarder's fast axis.
Mueller along_axis(const PolarizationElement& element, double retardance) {
    using Kind = PolarizationElement::Kind;
    const double t = element.transmittance;
    const double h = 0.5 * t;
    switch (element.kind) {
        case Kind::polarizer:
            return Mueller({h, -h, 0, 0, -h, h, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
        case Kind::retarder: {
            const double c = t * std::cos(retardance);
            const double s = t * std::sin(retardance);
            return Mueller({t, 0, 0, 0, 0, t, 0, 0, 0, 0, c, s, 0, 0, -s, c});
        }
        case Kind::right_circular:
            return Mueller({h, 0, 0, h, 0, 0, 0, 0, 0, 0, 0, 0, h, 0, 0, h});
        case Kind::left_circular:
            break;
    }
    return Mueller({h, 0, 0, -h, 0, 0, 0, 0, 0, 0, 0, 0, -h, 0, 0, h});
}

}  // namespace

void check_element_angle(double radians, std::string_view name) {
    if (!(std::abs(radians) <= kLargestElementAngle))
        refuse(std::string(name) + " is " + std::to_string(glm::degrees(radians)) +
               " degrees; it must lie in -1000000 to 1000000");
}

void check(const PolarizationElement& element) {
    check_element_angle(element.angle, "angle of an element");
    check_element_angle(element.retardance, "retardance of an element");
    if (!(element.transmittance >= 0 && element.transmittance <= 1))
        refuse("transmittance of an element is " + std::to_string(element.transmittance) +
               "; it must lie in 0 to 1");
}

PlacedElement::PlacedElement(const PolarizationElement& element, const glm::dmat4& from_world)
    : element_(element) {
    const glm::dmat4 placed = from_world * element.to_world;
    const glm::dmat3 axes(placed);
    center_ = placed[3];
    normal_ = glm::normalize(glm::transpose(glm::inverse(axes))[2]);
    const Frame frame = frame_with_x(normal_, axes[0]);
    const bool absorbs = element.kind == PolarizationElement::Kind::polarizer;
    x_ = absorbs ? frame[1] : frame[0];
    y_ = absorbs ? -frame[0] : frame[1];
    to_local_ = glm::inverse(glm::dmat3(axes[0], axes[1], normal_));
}

glm::dvec3 PlacedElement::axis(double angle) const {
    return std::cos(angle) * x_ + std::sin(angle) * y_;
}

std::optional<ElementCrossing> PlacedElement::crossing(const glm::dvec3& origin,
                                                       const glm::dvec3& direction) const {
    const glm::dvec3 from = to_local_ * (origin - center_);
    const glm::dvec3 step = to_local_ * direction;
    if (step.z == 0) return std::nullopt;
    const double distance = -from.z / step.z;
    const double x = from.x + distance * step.x;
    const double y = from.y + distance * step.y;
    const bool round = element_.outline == PolarizationElement::Outline::disk;
    const double out = round ? std::hypot(x, y) : std::max(std::abs(x), std::abs(y));
    if (!(out <= 1)) return std::nullopt;
    return ElementCrossing{distance, {x, y}};
}

Mueller PlacedElement::mueller(const Frame& received, double angle, double retardance) const {
    const glm::dvec3 along = axis(angle);
    const double rotation = std::atan2(glm::dot(along, received[1]), glm::dot(along, received[0]));
    const double cosine = std::abs(glm::dot(normal_, received[2]));
    return in_rotated_frames(along_axis(element_, retardance * cosine), -rotation, -rotation);
}

}  // namespace nicol
