// SPDX-License-Identifier: MIT
// Local lights as shading sees them: what reaches points from a place of the light.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "light/lane_light.hpp"
#include "light/local_light.hpp"

namespace nicol {

/// In the axes of the points that it lights. Immutable; threads share it.
class LightSource {
public:
    virtual ~LightSource() = default;
    LightSource(const LightSource&) = delete;
    LightSource& operator=(const LightSource&) = delete;

    /// How large the light is, seen from a point: the angular radius in radians, up to pi / 2, of a cone that
    /// it is in. 0: it has one place alone; else shadows are soft, and the mean over many is needed.
    [[nodiscard]] virtual float angular_radius(const glm::vec3& from) const noexcept = 0;

    /// What reaches sixteen points from the place that u and v, each in [0, 1), choose. The mean over u and v
    /// is all of the light. Of one place u and v do not matter.
    virtual void sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const = 0;

    /// What a mirror shows of the light: where rays from sixteen points, in unit directions, meet it. `out`
    /// has these points alone, and radiance in place of irradiance. A light of one place has none.
    virtual void intersect(const LaneVectors& points, const LaneVectors& directions,
                           LaneLight& out) const = 0;

protected:
    LightSource() = default;
};
using LightSourcePtr = std::unique_ptr<const LightSource>;

/// A light of a scene. `to_axes`: from the world to the points' axes, a rotation and a shift.
[[nodiscard]] LightSourcePtr light_source(const LocalLight& light, const glm::dmat4& to_axes);

/// An emissive surface, in the points' axes.
struct EmissiveSurface {
    const Emission& emission;
    glm::dvec3 axis;  ///< of its polarization, in these axes
    std::vector<std::array<glm::vec3, 3>> triangles;
    std::vector<std::array<glm::vec2, 3>> texcoords;  ///< where its emission has a texture that needs them
    bool mirrored = true;                             ///< someone will call intersect()
};
/// Null where it has no area. Its places are uniform over its area, of a sphere over what is seen of it.
[[nodiscard]] LightSourcePtr light_source(const EmissiveSurface& surface);

/// What light sources have in common: one colour, times a texture, of one polarization.
class SourceColor {
public:
    /// `axis`: of the polarization, in the points' axes. Texture null: 1.
    SourceColor(const std::vector<double>& value, TexturePtr texture, const PolarizationState& state,
                const glm::dvec3& axis);

    /// Sets irradiance and components, and the x axes of polarized light from its directions: the colour
    /// times a factor, at most kBrightestLight, as that of a light that a point touches would be infinite.
    void put(const Lanes& factor, LaneLight& out) const;
    /// The same times the texture, where there is one.
    void put(const Lanes& factor, const TexturePoints& at, LaneLight& out) const;
    [[nodiscard]] bool textured() const noexcept { return texture_ != nullptr; }

private:
    // Factors of each channel of three, or one of all.
    void put_factors(std::span<const Lanes> factors, LaneLight& out) const;
    void put_axes(LaneLight& out) const;

    std::vector<std::array<float, 4>> stokes_;  // by channel
    TexturePtr texture_;
    glm::vec3 axis_;
    std::size_t components_;
    float largest_factor_;
};

/// The angular radius of a ball, and pi / 2 within it.
[[nodiscard]] float angular_radius_of_ball(const glm::vec3& from, const glm::vec3& centre, float radius);

}  // namespace nicol
