// SPDX-License-Identifier: MIT
// Textures in place of the parameters of a model that has none itself.
#pragma once

#include "material/mixture.hpp"
#include "material/parameter.hpp"

namespace nicol {

/// Whether any of the parameters has a texture.
template <class... Parameters>
[[nodiscard]] bool textured(const Parameters&... parameters) {
    return ((parameters.texture != nullptr) || ...);
}

/// The values of a colour; 1 in place of a texture, which times() multiplies by.
[[nodiscard]] inline ColorParameter factor(const ColorParameter& color) {
    return color.texture ? ColorParameter{1.0} : color;
}

/// The material of factor(color), times the texture of the colour if it has one.
[[nodiscard]] inline MaterialPtr times(const MaterialPtr& material, const ColorParameter& color) {
    return color.texture ? scaled(material, color.texture) : material;
}

/// make(alpha) of a number, or an interpolation between roughnesses of its texture.
[[nodiscard]] inline MaterialPtr at_roughness(const std::function<MaterialPtr(double alpha)>& make,
                                              const NumberParameter& alpha) {
    return alpha.texture ? with_roughness(make, alpha.texture) : make(alpha.value);
}

}  // namespace nicol
