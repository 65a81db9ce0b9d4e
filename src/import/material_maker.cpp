// SPDX-License-Identifier: MIT
#include "import/material_maker.hpp"

namespace nicol {

MaterialPtr MaterialMaker::make(const MaterialDescription& description) const {
    files.budget().check();
    MaterialPtr front = description.model->make(*this);
    return description.twosided ? twosided(std::move(front)) : front;
}

ColorParameter MaterialMaker::color(const TexturedColor& color) const {
    if (color.texture) return textures.color(*color.texture);
    return reflectance(color, channels);
}

NumberParameter MaterialMaker::number(const TexturedNumber& number) const {
    return {number.value, number.texture ? textures.number(*number.texture) : nullptr};
}

}  // namespace nicol
