// SPDX-License-Identifier: MIT
// Lights of a place or a direction of their own, beside the light from all around.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

#include "light/polarization_state.hpp"
#include "texture/texture.hpp"

namespace nicol {

/// A light without a surface: cameras do not see it. In its own axes it emits light along +z, from the origin
/// where it has a place; up is +y, and +x is on the left of who looks along +z, as in Mitsuba 3.
struct LocalLight {
    enum class Kind {
        directional,  ///< parallel light from infinitely far, or from a disc of the sky
        point,        ///< in all directions
        spot,         ///< within a cone
        projector,    ///< a texture, or one colour, onto a rectangle
    };
    Kind kind = Kind::point;
    /// One value, or one a channel; 0 to kBrightestLight.
    /// directional: irradiance on a surface that faces the light; point, spot: intensity, on the axis of the
    /// latter; projector: irradiance on the plane z = 1 (of Mitsuba's: pi times its irradiance and scale).
    std::vector<double> value{1};
    glm::dmat4 to_world{1.0};   ///< a rotation and a shift
    double angular_radius = 0;  ///< directional: of the disc, radians, 0 to pi/2; its radiance is uniform
    double cutoff_angle = 0.3490658503988659;  ///< spot: half the cone's angle, radians, above 0, to pi/2
    double beam_width = 0.2617993877991494;    ///< spot: radians, 0 to cutoff_angle: from here the intensity
                                               ///< falls to 0 at the cutoff, linearly in the angle
    /// Times `value`, at light_texcoords(). Null: 1. 1 or 3 channels of values >= 0.
    TexturePtr texture;
    double fov = 0.7853981633974483;  ///< projector: horizontal, radians, above 0, below pi
    double aspect = 1;                ///< projector: width over height of the rectangle
    PolarizationState state;

    [[nodiscard]] int channels() const noexcept;
};

/// Throws Error(invalid_argument) naming the member that is out of range.
void check(const LocalLight& light);

/// What a surface emits. It reflects as well, as its material says.
struct Emission {
    std::vector<double> radiance{1};  ///< one value or one a channel; 0 to kBrightestLight
    TexturePtr texture;               ///< times it; null: 1. 1 or 3 channels of values >= 0
    /// Of light from both sides; else from the front alone.
    bool two_sided = false;
    PolarizationState state;  ///< its axis is in the mesh's axes, before the instance's transform

    [[nodiscard]] int channels() const noexcept;
};
using EmissionPtr = std::shared_ptr<const Emission>;

/// Throws Error(invalid_argument) naming the member that is out of range.
void check(const Emission& emission);

/// How bright a spot is at an angle from its axis given by its cosine, of 1 on the axis.
[[nodiscard]] double spot_falloff(const LocalLight& spot, double cos_angle);

/// u and v of a spot's or a projector's texture along a direction of its own axes with z > 0, of any length,
/// as in Mitsuba 3. Spot: 0 to 1 is the square around its cone, u grows with x and v with y. Projector: 0 to
/// 1 is its rectangle, beyond which it is dark; u grows against x and v against y, so that the image is
/// upright.
[[nodiscard]] glm::dvec2 light_texcoords(const LocalLight& light, const glm::dvec3& direction);

/// A light's value, or a surface's radiance, in a channel, times its texture's, at(); 1 without.
[[nodiscard]] double textured_value(const std::vector<double>& value, const TexturePtr& texture,
                                    const glm::vec4& texel, int channel);

}  // namespace nicol
