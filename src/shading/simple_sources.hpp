// SPDX-License-Identifier: MIT
// Light sources of a simple shape: a direction or disc of the sky, a place without a size, and a sphere.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "light/lane_light.hpp"
#include "light/local_light.hpp"
#include "shading/light_source.hpp"

namespace nicol {

/// Light from a direction, or a disc of the sky.
class DirectionalSource final : public LightSource {
public:
    /// `axes`: of the light, a rotation into the points' axes.
    DirectionalSource(const LocalLight& light, const glm::dmat3& axes);

    [[nodiscard]] float angular_radius(const glm::vec3& /*from*/) const noexcept override { return radius_; }
    void sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const override;
    void intersect(const LaneVectors& points, const LaneVectors& directions, LaneLight& out) const override;

private:
    SourceColor color_;
    float radius_;
    float height_;   // 1 - cos(radius)
    float density_;  // irradiance of a place times the solid angle, over that of the whole disc
    glm::vec3 towards_, right_, up_;
};

/// Light from a place without a size: a point, a spot or a projector.
class PointSource final : public LightSource {
public:
    /// `to_axes`: from the light's own axes to the points', a rotation and a shift.
    PointSource(const LocalLight& light, const glm::dmat4& to_axes);

    [[nodiscard]] float angular_radius(const glm::vec3& /*from*/) const noexcept override { return 0; }
    void sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const override;
    void intersect(const LaneVectors& points, const LaneVectors& directions, LaneLight& out) const override;

private:
    // Multiplies `factor` by how bright the light is in directions in its own axes, and finds where they meet
    // its texture.
    void aim(const LaneVectors& directions, Lanes& factor, TexturePoints& at, LaneLight& out) const;

    LocalLight light_;
    SourceColor color_;
    glm::vec3 place_;
    glm::mat3 axes_;  // the light's own
};

/// A surface that is nearly a sphere.
struct EmissiveSphere {
    glm::dvec3 centre;
    double radius;        ///< of the sphere with the surface's area
    double outer_radius;  ///< of one that holds the surface
};
/// The sphere of a closed surface that faces outwards and is nearly a sphere, if the triangles are one.
[[nodiscard]] std::optional<EmissiveSphere> sphere_of(const std::vector<std::array<glm::vec3, 3>>& triangles);

/// Light from an emissive sphere. Its places are uniform over the solid angle that a point sees of it, so
/// that none is wasted on its far side.
class SphereSource final : public LightSource {
public:
    /// `axis`: see EmissiveSurface.
    SphereSource(const EmissiveSphere& sphere, const Emission& emission, const glm::dvec3& axis);

    [[nodiscard]] float angular_radius(const glm::vec3& from) const noexcept override;
    void sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const override;
    void intersect(const LaneVectors& points, const LaneVectors& directions, LaneLight& out) const override;

private:
    SourceColor color_;
    glm::vec3 centre_;
    float radius_;
    float outer_radius_;  // where rays to the light end, so that its own triangles do not hide it
};

}  // namespace nicol
