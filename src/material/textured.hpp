// SPDX-License-Identifier: MIT
// Textures for the parameters of a model that takes only values.
#pragma once

#include "material/mixture.hpp"
#include "material/parameter.hpp"

namespace nicol {

/// Returns whether any of the parameters has a texture.
template <class... Parameters>
[[nodiscard]] bool textured(const Parameters&... parameters) {
    return ((parameters.texture != nullptr) || ...);
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

}  // namespace nicol
