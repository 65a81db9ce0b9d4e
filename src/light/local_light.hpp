// SPDX-License-Identifier: MIT
// Local lights and the emission of surfaces.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <string_view>
#include <vector>

#include "light/polarization_state.hpp"
#include "texture/texture.hpp"

namespace nicol {

/// Local light without a surface. Cameras do not see it. In its local axes it emits light along +z, from the
/// origin unless it is directional; up is +y, and +x is on the left of a viewer who looks along +z, as in
/// Mitsuba 3.
struct LocalLight {
    enum class Kind {
        directional,  ///< parallel light from infinitely far, or from a disc of the sky
        point,        ///< emits in all directions
        spot,         ///< emits within a cone
        projector,    ///< projects a texture, or one colour, onto a rectangle
    };
    Kind kind = Kind::point;
    /// One value, or one per channel; 0 to kBrightestLight. directional: irradiance on a surface that faces
    /// the light; point: intensity; spot: intensity on the axis; projector: irradiance on the plane z = 1 (pi
    /// times irradiance and scale of Mitsuba's projector).
    std::vector<double> value{1};
    glm::dmat4 to_world{1.0};   ///< rotation and translation
    double angular_radius = 0;  ///< directional: disc's radius, radians, 0 to pi/2; uniform radiance
    double cutoff_angle = 0.3490658503988659;  ///< spot: half the cone's angle, radians, above 0, to pi/2
    double beam_width = 0.2617993877991494;    ///< spot: angle, radians, 0 to cutoff_angle, from which the
                                               ///< intensity falls to 0 at the cutoff, linearly in the angle
    /// Factor on `value` at light_texcoords(). Null: 1. 1 or 3 channels of values >= 0.
    TexturePtr texture;
    double fov = 0.7853981633974483;  ///< projector: horizontal field of view, radians, above 0, below pi
    double aspect = 1;                ///< projector: width over height of the rectangle
    PolarizationState state;
    bool operator==(const LocalLight&) const = default;

    [[nodiscard]] int channels() const noexcept;
};

/// Throws Error(invalid_argument) that names the member that is out of range.
void check(const LocalLight& light);

/// Emission of a surface. The surface also reflects as its material specifies.
struct Emission {
    std::vector<double> radiance{1};  ///< one value or one per channel; 0 to kBrightestLight
    TexturePtr texture;               ///< factor on radiance; null: 1. 1 or 3 channels of values >= 0
    /// Whether both sides emit; else only the front emits.
    bool two_sided = false;
    PolarizationState state;  ///< `axis` is in the mesh's axes, before the instance's transform
    bool operator==(const Emission&) const = default;

    [[nodiscard]] int channels() const noexcept;
};
using EmissionPtr = std::shared_ptr<const Emission>;

/// Returns whether the texture of an emission, which may be null, needs these colours of the mesh.
[[nodiscard]] inline bool needs_colors(const Emission* emission, ColorsOf of) {
    return emission != nullptr && emission->texture != nullptr && emission->texture->needs_colors(of);
}

/// Throws Error(invalid_argument) that names the member that is out of range.
void check(const Emission& emission);

// Each kind of light has one row in local_light.cpp that the functions below and check() read.

/// Returns the name of a kind in messages, such as "point light".
[[nodiscard]] std::string_view light_name(LocalLight::Kind kind);

/// Returns the irradiance at distance 1 of a surface that faces the light, divided by the light's value and
/// texture, for a unit direction of the light's local axes; 0 where it emits nothing. directional: the
/// irradiance at every distance.
[[nodiscard]] double light_pattern(const LocalLight& light, const glm::dvec3& direction);

/// Returns directions of the light's local axes, of any length, whose convex hull holds the directions of all
/// its light. A margin of 1e-6 of their width lies outside. Empty: the light emits in all directions.
[[nodiscard]] std::vector<glm::dvec3> light_outline(const LocalLight& light);

/// Returns u and v of the texture of a light that may have one along a direction of the light's local axes
/// with z > 0, of any length, as in Mitsuba 3. Spot: 0 to 1 is the square around its cone, u grows with x and
/// v with y. Projector: 0 to 1 is its rectangle, beyond which it is dark; u grows against x and v against y,
/// so that the image is upright.
[[nodiscard]] glm::dvec2 light_texcoords(const LocalLight& light, const glm::dvec3& direction);

/// Returns a light's value, or a surface's radiance, in a channel, times `texel`, the value of the texture's
/// at(). Without a texture the factor is 1.
[[nodiscard]] double textured_value(const std::vector<double>& value, const TexturePtr& texture,
                                    const glm::vec4& texel, int channel);

}  // namespace nicol
