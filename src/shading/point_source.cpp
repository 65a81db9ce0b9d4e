// SPDX-License-Identifier: MIT
#include "shading/point_source.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace nicol {
namespace {

constexpr float kNearest = 1e-30F;  // of squared distances, which are divided by

// Irradiance on a surface that faces the light at the distance 1, over the light's value, in a unit direction
// of its own axes.
double pattern(const SmallLight& light, const glm::dvec3& direction) {
    if (light.kind == SmallLight::Kind::spot) return spot_falloff(light, direction.z);
    const double half_width = std::tan(light.fov / 2);
    const bool inside = direction.z > 0 && std::abs(direction.x) <= half_width * direction.z &&
                        std::abs(direction.y) * light.aspect <= half_width * direction.z;
    return inside ? 1 / (direction.z * direction.z * direction.z) : 0;
}

}  // namespace

PointSource::PointSource(const SmallLight& light, const glm::dmat4& to_axes)
    : light_(light),
      color_(light.value, light.texture, light.state, glm::dmat3(to_axes) * light.state.axis),
      place_(to_axes[3]),
      axes_(to_axes) {}

void PointSource::sample(const LaneVectors& points, const Lanes&, const Lanes&, LaneLight& out) const {
    Lanes factor;
    LaneVectors own;  // the light's direction, in its own axes
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = place_.x - points.x[i];
        const float y = place_.y - points.y[i];
        const float z = place_.z - points.z[i];
        const float square = std::max(x * x + y * y + z * z, kNearest);
        const float distance = std::sqrt(square);
        out.distance[i] = distance;
        out.towards.x[i] = x / distance;
        out.towards.y[i] = y / distance;
        out.towards.z[i] = z / distance;
        factor[i] = 1 / square;
        own.x[i] = -(axes_[0].x * x + axes_[0].y * y + axes_[0].z * z) / distance;
        own.y[i] = -(axes_[1].x * x + axes_[1].y * y + axes_[1].z * z) / distance;
        own.z[i] = -(axes_[2].x * x + axes_[2].y * y + axes_[2].z * z) / distance;
    }
    out.points = 0xFFFF;
    TexturePoints at{};
    if (light_.kind != SmallLight::Kind::point) aim(own, factor, at, out);
    color_.put(factor, at, out);
}

void PointSource::intersect(const LaneVectors&, const LaneVectors&, LaneLight& out) const {
    out.points = 0;
}

void PointSource::aim(const LaneVectors& directions, Lanes& factor, TexturePoints& at, LaneLight& out) const {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::dvec3 direction(directions.x[i], directions.y[i], directions.z[i]);
        const double aimed = pattern(light_, direction);
        if (aimed == 0) out.points &= ~(1U << i);
        factor[i] *= static_cast<float>(aimed);
        if (!color_.textured() || !(direction.z > 0)) continue;
        const glm::vec2 uv = light_texcoords(light_, direction);
        at.uv[0][i] = uv.x;
        at.uv[1][i] = uv.y;
    }
}

}  // namespace nicol
