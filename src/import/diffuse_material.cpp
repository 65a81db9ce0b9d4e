// SPDX-License-Identifier: MIT
#include "import/diffuse_material.hpp"

#include "import/material_readers.hpp"

namespace nicol::scene {

MaterialPtr DiffuseModel::make(const MaterialMaker& maker) const {
    return diffuse(maker.color(reflectance));
}

bool DiffuseModel::black() const {
    return !reflectance.texture && reflectance == ColorDescription(0.0);
}

MaterialDescription read_diffuse(const MaterialSource& source) {
    DiffuseModel model;
    model.reflectance = read_color(source.document, source.plugin, "reflectance", 0.5, 1.0);
    return model;
}

}  // namespace nicol::scene
