// SPDX-License-Identifier: MIT
// Materials that light passes as glTF describes them (KHR_materials_transmission, KHR_materials_volume).
#pragma once

#include <glm/vec3.hpp>
#include <utility>

#include "import/late_parameters.hpp"

namespace nicol::scene {

/// Boundary that light passes, beside what its front reflects.
struct GlassDescription {
    double index;                ///< index of the inside
    double share;                ///< share of the light that passes, 0 to 1
    TexturedColor color;         ///< colour of the light that passes; its mean if a texture
    TexturedNumber alpha;        ///< roughness; its mean if a texture
    bool is_body = false;        ///< true: the light is refracted; false: the surface is a thin sheet
    glm::dvec3 absorption{0.0};  ///< absorption coefficient of the body, per unit of length
};

/// A material that reflects on its front and that light passes.
struct GlassModel final : MaterialModel {
    GlassModel(MaterialDescription reflecting, GlassDescription with)
        : reflection(std::move(reflecting)), glass(std::move(with)) {}

    MaterialDescription reflection;
    GlassDescription glass;

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

}  // namespace nicol::scene
