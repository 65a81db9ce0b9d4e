// SPDX-License-Identifier: MIT
#include "shading/simple_sources.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "light/lane_light.hpp"
#include "simd/lane_angle.hpp"

namespace nicol {
namespace {

double half_sine_squared(double angle) {
    const double sine = std::sin(angle / 2);
    return sine * sine;
}

constexpr float kNearest = 1e-30F;  // smallest squared distance, which is a divisor

/// Returns the distance along a ray to a ball; the ray passes the centre at the distance `beside`, after
/// `along`.
float until_ball(float along, float beside, float radius) {
    return std::max(0.0F, along - std::sqrt(std::max(0.0F, radius * radius - beside * beside)));
}

/// Distant light from one direction or from a disc.
class DirectionalSource final : public LightSource {
public:
    /// Takes `axes`, a rotation from the light's axes to the points' axes.
    DirectionalSource(const LocalLight& light, SourceColor color, const glm::dmat3& axes);

    [[nodiscard]] float angular_radius(const glm::vec3& /*from*/) const noexcept override { return radius_; }
    [[nodiscard]] float brightness(const glm::vec3& /*from*/) const noexcept override {
        return color_.brightest();
    }
    void sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const override;
    void intersect(const LaneVectors& points, const LaneVectors& directions, LaneLight& out) const override;

private:
    SourceColor color_;
    float radius_;
    float height_;   // 1 - cos(radius)
    float density_;  // irradiance of a sample times the solid angle, over that of the whole disc
    glm::vec3 towards_, right_, up_;
};

/// Light from a point without a size: a point light, a spot or a projector.
class PointSource final : public LightSource {
public:
    /// Takes `to_axes`, a rotation and shift from the light's own axes to the points'.
    PointSource(LocalLight light, SourceColor color, const glm::dmat4& to_axes);

    [[nodiscard]] float angular_radius(const glm::vec3& /*from*/) const noexcept override { return 0; }
    [[nodiscard]] float brightness(const glm::vec3& from) const noexcept override;
    void sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const override;
    void intersect(const LaneVectors& points, const LaneVectors& directions, LaneLight& out) const override;

private:
    // Multiplies `factor` by the light's directional pattern in directions in its own axes, and finds their
    // texture coordinates.
    void aim(const LaneVectors& directions, Lanes& factor, TexturePoints& at, LaneLight& out) const;

    LocalLight light_;
    SourceColor color_;
    glm::vec3 place_;
    glm::mat3 axes_;  // the light's own axes
};

/// Surface that is nearly a sphere.
struct EmissiveSphere {
    glm::dvec3 centre;
    double radius;        ///< radius of the sphere with the surface's area
    double outer_radius;  ///< radius of a sphere that contains the surface
};
/// Light from an emissive sphere.
class SphereSource final : public LightSource {
public:
    /// Takes `axis`, the axis of the polarization, as in EmissiveSurface.
    SphereSource(const EmissiveSphere& sphere, const Emission& emission, const glm::dvec3& axis);

    [[nodiscard]] float angular_radius(const glm::vec3& from) const noexcept override;
    [[nodiscard]] float brightness(const glm::vec3& from) const noexcept override;
    void sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const override;
    void intersect(const LaneVectors& points, const LaneVectors& directions, LaneLight& out) const override;

private:
    SourceColor color_;
    glm::vec3 centre_;
    float radius_;
    float outer_radius_;  // end of rays to the light, so that its own triangles do not hide it
};

// A uniform disc of radius r and radiance L gives the irradiance L pi sin^2 r on a surface that faces it.
// Each light sample represents the whole solid angle, 4 pi sin^2 (r / 2).
DirectionalSource::DirectionalSource(const LocalLight& light, SourceColor color, const glm::dmat3& axes)
    : color_(std::move(color)),
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
        // The square of a chord is accurate for small angles, unlike cosines.
        const bool meets = height_ > 0 && x * x + y * y + z * z <= 2 * height_;
        if (meets) out.points |= 1U << i;
        out.distance[i] = std::numeric_limits<float>::infinity();
        radiance[i] = meets ? 1 / (std::numbers::pi_v<float> * height_ * (2 - height_)) : 0;
    }
    color_.put(radiance, out);
}

PointSource::PointSource(LocalLight light, SourceColor color, const glm::dmat4& to_axes)
    : light_(std::move(light)), color_(std::move(color)), place_(to_axes[3]), axes_(to_axes) {}

float PointSource::brightness(const glm::vec3& from) const noexcept {
    const glm::vec3 way = place_ - from;
    return color_.brightest() / std::max(kNearest, glm::dot(way, way));
}

void PointSource::sample(const LaneVectors& points, const Lanes&, const Lanes&, LaneLight& out) const {
    Lanes factor;
    LaneVectors own;  // direction from the light in its own axes
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
    if (light_.kind != LocalLight::Kind::point) aim(own, factor, at, out);
    color_.put(factor, at, out);
}

void PointSource::intersect(const LaneVectors&, const LaneVectors&, LaneLight& out) const {
    out.points = 0;
}

void PointSource::aim(const LaneVectors& directions, Lanes& factor, TexturePoints& at, LaneLight& out) const {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::dvec3 direction(vector_at(directions, i));
        const double aimed = light_pattern(light_, direction);
        if (aimed == 0) out.points &= ~(1U << i);
        factor[i] *= static_cast<float>(aimed);
        if (!color_.textured() || !(direction.z > 0)) continue;
        const glm::vec2 uv = light_texcoords(light_, direction);
        at.uv[0][i] = uv.x;
        at.uv[1][i] = uv.y;
    }
}

std::optional<EmissiveSphere> sphere_of(const std::vector<std::array<glm::vec3, 3>>& triangles) {
    constexpr double pi = std::numbers::pi;
    double area = 0;
    glm::dvec3 centre(0);
    for (const std::array<glm::vec3, 3>& t : triangles) {
        const glm::dvec3 a(t[0]), b(t[1]), c(t[2]);
        const double own = glm::length(glm::cross(b - a, c - a)) / 2;
        area += own;
        centre += own / 3 * (a + b + c);
    }
    if (!(area > 0)) return std::nullopt;
    centre /= area;
    const double radius = std::sqrt(area / (4 * pi));
    // The tolerance admits a sphere of 12 by 24 parts, whose area is 2 % smaller.
    constexpr double tolerance = 0.03;
    double outer_radius = radius;
    double cones = 0;  // volume: the sum of the cones over the triangles
    for (const std::array<glm::vec3, 3>& t : triangles) {
        const glm::dvec3 a = glm::dvec3(t[0]) - centre, b = glm::dvec3(t[1]) - centre,
                         c = glm::dvec3(t[2]) - centre;
        for (const glm::dvec3& corner : {a, b, c}) {
            if (!(std::abs(glm::length(corner) - radius) <= tolerance * radius)) return std::nullopt;
            outer_radius = std::max(outer_radius, glm::length(corner));
        }
        cones += glm::dot(a, glm::cross(b, c)) / 6;
    }
    // The volume differs unless the surface is closed, covers the sphere once and faces outwards.
    const double volume = 4 * pi / 3 * radius * radius * radius;
    if (!(std::abs(cones - volume) <= 2 * tolerance * volume)) return std::nullopt;
    return EmissiveSphere{.centre = centre, .radius = radius, .outer_radius = outer_radius};
}

SphereSource::SphereSource(const EmissiveSphere& sphere, const Emission& emission, const glm::dvec3& axis)
    : color_(emission.radiance, nullptr, emission.state, axis),
      centre_(sphere.centre),
      radius_(static_cast<float>(sphere.radius)),
      outer_radius_(static_cast<float>(sphere.outer_radius)) {}

float SphereSource::brightness(const glm::vec3& from) const noexcept {
    return color_.brightest() * irradiance_of_ball(from, centre_, radius_);
}

float SphereSource::angular_radius(const glm::vec3& from) const noexcept {
    return angular_radius_of_ball(from, centre_, radius_);
}

void SphereSource::sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const {
    Lanes solid_angle;
    out.points = 0;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::vec3 way = centre_ - vector_at(points, i);
        const float to_centre = std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
        const bool outside = to_centre > radius_;
        if (outside) out.points |= 1U << i;
        const float ratio = outside ? radius_ / to_centre : 1;
        const float widest =
            ratio * ratio / (1 + std::sqrt(std::max(0.0F, 1 - ratio * ratio)));  // 1 - cosine
        const float fall = u[i] * widest;
        const float sine = std::sqrt(fall * (2 - fall));
        float x = 0, y = 0;
        turn(v[i], x, y);

        // Frame about the direction to the centre (Duff et al. 2017).
        const glm::vec3 z = outside ? way / to_centre : glm::vec3(0, 0, 1);
        const float sign = std::copysign(1.0F, z.z);
        const float a = -1 / (sign + z.z);
        const float b = z.x * z.y * a;
        const glm::vec3 right(1 + sign * z.x * z.x * a, sign * b, -sign * z.x);
        const glm::vec3 up(b, sign + z.y * z.y * a, -z.y);
        const glm::vec3 towards = (1 - fall) * z + sine * x * right + sine * y * up;
        out.towards.x[i] = towards.x;
        out.towards.y[i] = towards.y;
        out.towards.z[i] = towards.z;
        out.distance[i] = until_ball(to_centre * (1 - fall), to_centre * sine, outer_radius_);
        solid_angle[i] = 2 * std::numbers::pi_v<float> * widest;
    }
    color_.put(solid_angle, out);
}

void SphereSource::intersect(const LaneVectors& points, const LaneVectors& directions, LaneLight& out) const {
    Lanes one;
    out.towards = directions;
    out.points = 0;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::vec3 way = centre_ - vector_at(points, i);
        const glm::vec3 direction = vector_at(directions, i);
        const float along = glm::dot(way, direction);
        const glm::vec3 beside = way - along * direction;
        const float square = radius_ * radius_;
        const bool meets = along > 0 && glm::dot(beside, beside) <= square && glm::dot(way, way) > square;
        if (meets) out.points |= 1U << i;
        out.distance[i] = until_ball(along, glm::length(beside), outer_radius_);
        one[i] = 1;
    }
    color_.put(one, out);
}

}  // namespace

LightSourcePtr simple_source(const LocalLight& light, SourceColor color, const glm::dmat4& to_axes) {
    if (light.kind == LocalLight::Kind::directional)
        return std::make_unique<const DirectionalSource>(light, std::move(color), glm::dmat3(to_axes));
    return std::make_unique<const PointSource>(light, std::move(color), to_axes);
}

LightSourcePtr sphere_source(const EmissiveSurface& surface) {
    const std::optional<EmissiveSphere> sphere = sphere_of(surface.triangles);
    if (!sphere) return nullptr;
    return std::make_unique<const SphereSource>(*sphere, surface.emission, surface.axis);
}

}  // namespace nicol
