// SPDX-License-Identifier: MIT
// Anisotropic materials as glTF describes them (KHR_materials_anisotropy).
#pragma once

#include <functional>
#include <utility>

#include "import/late_parameters.hpp"

namespace nicol::scene {

/// Returns the roughness along the direction of anisotropy, for the roughness across it.
[[nodiscard]] inline double widened(double alpha, double strength) {
    return alpha + (1 - alpha) * strength * strength;
}

/// A material whose facets are widened() along u.
struct BrushedModel final : MaterialModel {
    using WithFacets = std::function<MaterialDescription(const FacetDescription&)>;
    BrushedModel(WithFacets model, TexturedNumber alpha_across, TexturedNumber strength_along)
        : of(std::move(model)), alpha(std::move(alpha_across)), strength(std::move(strength_along)) {}

    WithFacets of;  ///< the material with these facets
    TexturedNumber alpha, strength;

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

/// A material whose anisotropic parts are rotated within the surface; see TangentRotation.
struct RotatedModel final : MaterialModel {
    RotatedModel(MaterialDescription of, TextureSpecificationPtr by, double and_angle)
        : base(std::move(of)), directions(std::move(by)), angle(and_angle) {}

    MaterialDescription base;
    TextureSpecificationPtr directions;  ///< null: none
    double angle;                        ///< in radians

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

}  // namespace nicol::scene
