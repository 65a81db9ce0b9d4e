// SPDX-License-Identifier: MIT
#include "import/specular_material.hpp"

#include "material/mixture.hpp"

namespace nicol::scene {

MaterialPtr SpecularModel::make(const MaterialMaker& maker) const {
    return sum(scaled(maker.make(plastic), maker.textures.color(*share)), maker.make(mirror));
}

}  // namespace nicol::scene
