// SPDX-License-Identifier: MIT
// Interface of local lights for shading: the light that reaches points from samples of a light.
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

/// A local light in the axes of the points that it lights. Immutable; threads share it.
class LightSource {
public:
    virtual ~LightSource() = default;
    LightSource(const LightSource&) = delete;
    LightSource& operator=(const LightSource&) = delete;

    /// Returns the angular size of the light seen from a point: the angular radius, in radians up to pi / 2,
    /// of a cone that contains the light. 0: the light is one point or direction. Otherwise shadows are soft,
    /// and shading needs the mean over many light samples.
    [[nodiscard]] virtual float angular_radius(const glm::vec3& from) const noexcept = 0;

    /// Returns an estimate of the irradiance on a surface at a point that faces the light: of the brightest
    /// channel, without textures and directional patterns.
    [[nodiscard]] virtual float brightness(const glm::vec3& from) const noexcept = 0;

    /// Computes the light at sixteen points from the light sample that u and v, each in [0, 1), choose. The
    /// mean over u and v is the light's full irradiance. u and v have no effect if angular_radius() is 0.
    virtual void sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const = 0;

    /// Intersects rays from sixteen points, in unit directions, with the light, for mirror reflection. `out`
    /// contains the points whose rays meet the light, and radiance in place of irradiance. A light with
    /// angular_radius() 0 is never met.
    virtual void intersect(const LaneVectors& points, const LaneVectors& directions,
                           LaneLight& out) const = 0;

protected:
    LightSource() = default;
};
using LightSourcePtr = std::unique_ptr<const LightSource>;

/// Returns the light source of a scene's light, or null if its value is 0. `to_axes`: rotation and shift from
/// the world to the points' axes.
[[nodiscard]] LightSourcePtr light_source(const LocalLight& light, const glm::dmat4& to_axes);

/// Returns four lights side by side that differ from a scene's light in value and state: the Stokes vectors
/// are (1, 0, 0, 0) to (0, 0, 0, 1), in the frame of the light's axis. The source's channels are
/// [component][channel]. What a light lights is the sum over them, times its own Stokes vector.
[[nodiscard]] LightSourcePtr unit_sources(const LocalLight& light, int channels, const glm::dmat4& to_axes);

/// Emissive surface, in the points' axes.
struct EmissiveSurface {
    const Emission& emission;
    glm::dvec3 axis;  ///< axis of the emission's polarization, in the points' axes
    std::vector<std::array<glm::vec3, 3>> triangles;
    std::vector<std::array<glm::vec2, 3>> texcoords;    ///< empty unless the emission's texture needs them
    std::vector<std::array<glm::vec3, 3>> colors = {};  ///< empty unless the emission's texture needs them
    bool mirrored = true;                               ///< whether intersect() will be called
};
/// Returns the light source of a surface, or null if its area or its radiance is 0. Light samples are uniform
/// over the surface's area; for a sphere, they are uniform over the visible solid angle.
[[nodiscard]] LightSourcePtr light_source(const EmissiveSurface& surface);

/// Colour of a light source: one value, times a texture, with one polarization state.
class SourceColor {
public:
    /// Takes `axis`, the axis of the polarization, in the points' axes. A null texture counts as 1.
    SourceColor(const std::vector<double>& value, TexturePtr texture, const PolarizationState& state,
                const glm::dvec3& axis);
    /// Returns the colour of unit_sources().
    [[nodiscard]] static SourceColor units(int channels, TexturePtr texture, const glm::dvec3& axis);

    /// Sets irradiance and components of `out`, and the x axes of polarized light from its directions. The
    /// irradiance is the colour times a factor; it is at most kBrightestLight, because the irradiance of a
    /// light that touches a point would be infinite.
    void put(const Lanes& factor, LaneLight& out) const;
    /// Sets the values of put() times the texture, if there is one.
    void put(const Lanes& factor, const TexturePoints& at, LaneLight& out) const;
    [[nodiscard]] bool textured() const noexcept { return texture_ != nullptr; }
    /// Returns the value of the brightest channel.
    [[nodiscard]] float brightest() const noexcept { return brightest_; }

private:
    // Sets the irradiance from the factors of three channels, or from one factor for all channels.
    void put_factors(std::span<const Lanes> factors, LaneLight& out) const;
    void put_axes(LaneLight& out) const;

    std::vector<std::array<float, 4>> stokes_;  // by channel
    TexturePtr texture_;
    glm::vec3 axis_;
    std::size_t components_;
    float largest_factor_;
    float brightest_;
};

/// Returns the irradiance of a ball of radiance 1 on a surface that faces it; pi within the ball.
[[nodiscard]] float irradiance_of_ball(const glm::vec3& from, const glm::vec3& centre, float radius);

/// Returns the angular radius of a ball seen from a point; pi / 2 within the ball.
[[nodiscard]] float angular_radius_of_ball(const glm::vec3& from, const glm::vec3& centre, float radius);

}  // namespace nicol
