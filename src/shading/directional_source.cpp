// SPDX-License-Identifier: MIT
#include "shading/directional_source.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "simd/lane_angle.hpp"

namespace nicol {
namespace {

double half_sine_squared(double angle) {
    const double sine = std::sin(angle / 2);
    return sine * sine;
}

}  // namespace

// A uniform disc of radius r and radiance L sheds L pi sin^2 r onto a surface that faces it, and each place
// stands for its whole solid angle, 4 pi sin^2 (r / 2).
DirectionalSource::DirectionalSource(const SmallLight& light, const glm::dmat3& axes)
    : color_(light.value, nullptr, light.state, axes * light.state.axis),
      radius_(static_cast<float>(light.angular_radius)),
      height_(static_cast<float>(2 * half_sine_squared(light.angular_radius))),
      density_(static_cast<float>(1 / (1 - half_sine_squared(light.angular_radius)))),
      towards_(-axes[2]),
      right_(axes[0]),
      up_(axes[1]) {}

void DirectionalSource::sample(const LaneVectors&, const Lanes& u, const Lanes& v, LaneLight& out) const {
    Lanes factor;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float fall = u[i] * height_;
        const float sine = std::sqrt(fall * (2 - fall));
        float x = 0, y = 0;
        turn(v[i], x, y);
        x *= sine;
        y *= sine;
        out.towards.x[i] = (1 - fall) * towards_.x + x * right_.x + y * up_.x;
        out.towards.y[i] = (1 - fall) * towards_.y + x * right_.y + y * up_.y;
        out.towards.z[i] = (1 - fall) * towards_.z + x * right_.z + y * up_.z;
        out.distance[i] = std::numeric_limits<float>::infinity();
        factor[i] = density_;
    }
    out.points = 0xFFFF;
    color_.put(factor, out);
}

void DirectionalSource::intersect(const LaneVectors&, const LaneVectors& directions, LaneLight& out) const {
    Lanes radiance;
    out.towards = directions;
    out.points = 0;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float x = directions.x[i] - towards_.x;
        const float y = directions.y[i] - towards_.y;
        const float z = directions.z[i] - towards_.z;
        // The square of a chord, which is exact for small angles, where cosines are not.
        const bool meets = height_ > 0 && x * x + y * y + z * z <= 2 * height_;
        if (meets) out.points |= 1U << i;
        out.distance[i] = std::numeric_limits<float>::infinity();
        radiance[i] = meets ? 1 / (std::numbers::pi_v<float> * height_ * (2 - height_)) : 0;
    }
    color_.put(radiance, out);
}

}  // namespace nicol
