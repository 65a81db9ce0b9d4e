// SPDX-License-Identifier: MIT
#include "reference/light_arrival.hpp"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace nicol {

using Kind = LocalLight::Kind;

bool without_size(const LocalLight& light) noexcept {
    return light.kind != Kind::directional || light.angular_radius == 0;
}

glm::dvec3 axis_in_world(const glm::dmat4& to_world, const PolarizationState& state) {
    return glm::normalize(glm::dmat3(to_world) * state.axis);
}

std::optional<LightArrival> light_arrival(const LocalLight& light, const glm::dvec3& position,
                                          std::span<double> irradiance) {
    const glm::dmat3 axes(light.to_world);
    const auto fill = [&](double factor, const glm::vec4& texel) {
        for (std::size_t c = 0; c < irradiance.size(); ++c)
            irradiance[c] = factor * textured_value(light.value, light.texture, texel, static_cast<int>(c));
    };
    if (light.kind == Kind::directional) {
        fill(1, glm::vec4(1));
        return LightArrival{.towards_light = -glm::normalize(axes[2]),
                            .distance = std::numeric_limits<double>::infinity()};
    }
    const glm::dvec3 way = position - glm::dvec3(light.to_world[3]);
    const double distance = glm::length(way);
    if (!(distance > 0)) return std::nullopt;
    const glm::dvec3 along = glm::transpose(axes) * way / distance;
    const double pattern = light_pattern(light, along);
    if (pattern == 0) return std::nullopt;
    glm::vec4 texel(1);
    if (light.texture != nullptr) texel = light.texture->at({.uv = glm::vec2(light_texcoords(light, along))});
    fill(pattern / (distance * distance), texel);
    return LightArrival{.towards_light = -way / distance, .distance = distance};
}

}  // namespace nicol
