// SPDX-License-Identifier: MIT
#include "import/primitive_detail.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace nicol {
namespace {

// Largest distance, in pixels, of an outline from the true one.
constexpr double kOutline = 0.05;
// The same for a shape of radius 1 at full detail, see make_sphere().
constexpr double kSagitta = 2.1e-4;
// Width that pictures are taken to have at least, since small ones are often drawn larger later.
constexpr double kLeastWidth = 256;
// Detail falls in steps to the root of a half, so that shapes of nearly one size share a mesh.
constexpr int kSteps = 4;

}  // namespace

PrimitiveDetail::PrimitiveDetail(const Camera& camera, glm::ivec2 size)
    : eye_(camera.to_world[3]), orthographic_(camera.orthographic) {
    const double half = std::max(static_cast<double>(size.x), kLeastWidth) / 2;
    scale_ = orthographic_ ? half / glm::length(glm::dvec3(camera.to_world[0]))
                           : half / std::tan(glm::radians(camera.fov) / 2);
}

double PrimitiveDetail::of(const ShapeDescription& shape) const {
    const bool cylinder = shape.kind == ShapeDescription::Kind::cylinder;
    const bool disk = shape.kind == ShapeDescription::Kind::disk;
    const bool curved = cylinder || disk || shape.kind == ShapeDescription::Kind::sphere;
    if (!curved || shape.emission) return 1;
    const glm::dmat3 axes(shape.to_world);
    const double stretch = std::max({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
    const double radius = stretch * (disk ? 1 : shape.radius);
    // The shape lies within `reach` of this point.
    const glm::dvec3 middle = cylinder ? (shape.p0 + shape.p1) / 2.0 : disk ? glm::dvec3(0) : shape.center;
    const double reach = radius + (cylinder ? stretch * glm::distance(shape.p0, shape.p1) / 2 : 0);
    const glm::dvec3 place(shape.to_world * glm::dvec4(middle, 1));
    const double distance = orthographic_ ? 1 : glm::distance(place, eye_) - reach;
    double wanted = 1;
    if (distance > 0) wanted = std::sqrt(kSagitta * radius * scale_ / distance / kOutline);
    int step = 0;
    while (step < kSteps && std::exp2(-0.5 * (step + 1)) >= wanted) ++step;
    return std::exp2(-0.5 * step);
}

}  // namespace nicol
