// SPDX-License-Identifier: MIT
// Textures for the parameters of a model that takes only values.
#pragma once

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "material/mixture.hpp"
#include "material/parameter.hpp"

namespace nicol {

/// Returns whether any of the parameters has a texture.
template <class... Parameters>
[[nodiscard]] bool textured(const Parameters&... parameters) {
    return ((parameters.texture != nullptr) || ...);
}

/// Returns the value of a number, or the mean of its texture, clamped to least..1.
[[nodiscard]] inline double mean_of(const NumberParameter& number, double least) {
    if (!number.texture) return number.value;
    return std::clamp(static_cast<double>(number.texture->mean().x), least, 1.0);
}
/// Returns the values of a colour, or the mean of its texture, clamped to 0..1.
[[nodiscard]] inline std::vector<double> mean_of(const ColorParameter& color) {
    if (!color.texture) return color.values;
    const glm::dvec3 mean = glm::clamp(glm::dvec3(color.texture->mean()), 0.0, 1.0);
    if (color.texture->channels() == 1) return {mean.x};
    return {mean.x, mean.y, mean.z};
}

/// Returns the values of a colour, or 1 for a texture, which times() multiplies by.
[[nodiscard]] inline ColorParameter factor(const ColorParameter& color) {
    return color.texture ? ColorParameter{1.0} : color;
}

/// Returns the material of factor(color), times the texture of the colour if there is one.
[[nodiscard]] inline MaterialPtr times(const MaterialPtr& material, const ColorParameter& color) {
    return color.texture ? scaled(material, color.texture) : material;
}

/// Returns make(alpha) of a number, or an interpolation between roughnesses of the texture.
[[nodiscard]] inline MaterialPtr at_roughness(const std::function<MaterialPtr(double alpha)>& make,
                                              const NumberParameter& alpha) {
    return alpha.texture ? with_roughness(make, alpha.texture) : make(alpha.value);
}

/// Returns make(alpha, alpha_v) of numbers, or an interpolation between roughnesses of the textures. alpha_v
/// is 0 if both directions have one roughness.
[[nodiscard]] inline MaterialPtr at_roughness(
    const std::function<MaterialPtr(double alpha, double alpha_v)>& make, const NumberParameter& alpha,
    const NumberParameter& alpha_v) {
    const auto texture_of = [](const NumberParameter& number) {
        return number.texture ? number.texture
                              : constant_texture(glm::vec4(static_cast<float>(number.value)), 1);
    };
    if (alpha_v.texture ? alpha_v.texture == alpha.texture : alpha_v.value == 0)
        return at_roughness([&](double both) { return make(both, 0); }, alpha);
    if (!textured(alpha, alpha_v)) return make(alpha.value, alpha_v.value);
    return with_roughness(make, texture_of(alpha), texture_of(alpha_v));
}

}  // namespace nicol
