// SPDX-License-Identifier: MIT
#include "light/local_light.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <string>
#include <string_view>

#include "arguments.hpp"
#include "light/environment.hpp"

namespace nicol {
namespace {

int channels_of(const std::vector<double>& values, const TexturePtr& texture) {
    const int of_texture = texture != nullptr ? texture->channels() : 1;
    return std::max(static_cast<int>(values.size()), of_texture);
}

void check_values(const std::vector<double>& values, std::string_view name) {
    if (values.empty()) refuse(std::string(name) + " has no value");
    for (const double value : values) {
        if (!(value >= 0 && value <= kBrightestLight))
            refuse(std::string(name) + " is " + std::to_string(value) + "; it must lie in 0 to 1e30");
    }
}

void check_texture(const TexturePtr& texture, std::size_t values) {
    if (texture == nullptr) return;
    if (texture->channels() != 1 && texture->channels() != 3)
        refuse("the texture of a light has " + std::to_string(texture->channels()) +
               " channels; it must have 1 or 3");
    if (texture->channels() == 3 && values != 1 && values != 3)
        refuse("the texture of a light has 3 channels and the light " + std::to_string(values));
    if (texture->range().x < 0) refuse("the texture of a light has negative values");
}

void check_angle(double value, double low, double high, std::string_view name) {
    if (value >= low && value <= high) return;
    refuse(std::string(name) + " is " + std::to_string(value) + "; it must lie in " + std::to_string(low) +
           " to " + std::to_string(high) + " radians");
}

void check_rigid(const glm::dmat4& m) {
    const glm::dmat3 axes(m);
    const glm::dmat3 product = glm::transpose(axes) * axes;
    constexpr double rounding = 1e-4;
    bool rigid = m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1 && glm::determinant(axes) > 0;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) rigid = rigid && std::abs(product[i][k] - (i == k ? 1 : 0)) <= rounding;
        rigid = rigid && std::isfinite(m[3][i]);
    }
    if (!rigid) refuse("to_world of a light must be a rotation and a shift");
}

}  // namespace

int LocalLight::channels() const noexcept {
    return channels_of(value, texture);
}

int Emission::channels() const noexcept {
    return channels_of(radiance, texture);
}

void check(const LocalLight& light) {
    using Kind = LocalLight::Kind;
    constexpr double half_turn = std::numbers::pi;
    constexpr double least = 1e-4;
    check_values(light.value, "the value of a light");
    check_rigid(light.to_world);
    check(light.state);
    if (light.kind == Kind::directional)
        check_angle(light.angular_radius, 0, half_turn / 2, "angular_radius");
    if (light.kind == Kind::spot) {
        check_angle(light.cutoff_angle, least, half_turn / 2, "cutoff_angle");
        check_angle(light.beam_width, 0, light.cutoff_angle, "beam_width");
    }
    if (light.kind == Kind::projector) {
        check_angle(light.fov, least, half_turn - least, "fov");
        if (!(light.aspect > 0 && std::isfinite(light.aspect)))
            refuse("aspect is " + std::to_string(light.aspect) + "; it must be finite and above 0");
    }
    const bool has_image = light.kind == Kind::spot || light.kind == Kind::projector;
    if (!has_image && light.texture != nullptr) refuse("only spots and projectors have a texture");
    check_texture(light.texture, light.value.size());
    if (light.texture != nullptr && needs_colors(*light.texture))
        refuse("the texture of a light cannot be the colours of a mesh");
}

void check(const Emission& emission) {
    check_values(emission.radiance, "the radiance of a surface");
    check(emission.state);
    check_texture(emission.texture, emission.radiance.size());
}

double spot_falloff(const LocalLight& spot, double cos_angle) {
    if (cos_angle >= std::cos(spot.beam_width)) return 1;
    if (cos_angle <= std::cos(spot.cutoff_angle)) return 0;
    return (spot.cutoff_angle - std::acos(cos_angle)) / (spot.cutoff_angle - spot.beam_width);
}

glm::dvec2 light_texcoords(const LocalLight& light, const glm::dvec3& direction) {
    const glm::dvec2 at = glm::dvec2(direction) / direction.z;
    if (light.kind == LocalLight::Kind::spot) return 0.5 + 0.5 / std::tan(light.cutoff_angle) * at;
    return 0.5 - 0.5 / std::tan(light.fov / 2) * glm::dvec2(1, light.aspect) * at;
}

double textured_value(const std::vector<double>& value, const TexturePtr& texture, const glm::vec4& texel,
                      int channel) {
    const double plain = value.size() == 1 ? value[0] : value[static_cast<std::size_t>(channel)];
    if (texture == nullptr) return plain;
    return plain * static_cast<double>(texel[texture->channels() == 1 ? 0 : channel]);
}

}  // namespace nicol
