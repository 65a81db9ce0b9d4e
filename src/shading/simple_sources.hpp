// SPDX-License-Identifier: MIT
// Light sources of simple shapes: a direction or distant disc, a point without a size, and a sphere.
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
/// Returns the sphere of a surface if the triangles are closed, face outwards and are nearly a sphere.
[[nodiscard]] std::optional<EmissiveSphere> sphere_of(const std::vector<std::array<glm::vec3, 3>>& triangles);

/// Light from an emissive sphere. Its light samples are uniform over the solid angle that is visible from a
/// point, so that no sample is wasted on the far side.
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

}  // namespace nicol
