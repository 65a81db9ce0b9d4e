// SPDX-License-Identifier: MIT
// Parameters of reflectance models that may vary over a surface.
#pragma once

#include <initializer_list>
#include <utility>
#include <vector>

#include "texture/texture.hpp"

namespace nicol {

/// A number, or a texture whose first channel replaces the number.
struct NumberParameter {
    NumberParameter(double number, TexturePtr of = nullptr) : value(number), texture(std::move(of)) {}
    NumberParameter(TexturePtr of) : NumberParameter(1, std::move(of)) {}

    double value;        ///< value in the parameter's range, even if there is a texture
    TexturePtr texture;  ///< null: the value holds
};

/// A colour, or a texture whose colours replace the colour. The colours of a texture should lie in 0..1, but
/// may exceed that range.
struct ColorParameter {
    ColorParameter(std::vector<double> color, TexturePtr of = nullptr)
        : values(std::move(color)), texture(std::move(of)) {}
    ColorParameter(std::initializer_list<double> color) : values(color) {}
    ColorParameter(TexturePtr of) : ColorParameter(std::vector{1.0}, std::move(of)) {}

    std::vector<double> values;  ///< one value, or one per channel
    TexturePtr texture;          ///< null: the values hold
};

}  // namespace nicol
