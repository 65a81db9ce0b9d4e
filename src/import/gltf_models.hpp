// SPDX-License-Identifier: MIT
// Models of glTF's extensions of materials: KHR_materials_anisotropy, KHR_materials_transmission with
// KHR_materials_volume, and KHR_materials_pbrSpecularGlossiness.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <utility>

#include "import/late_parameters.hpp"
#include "import/material_maker.hpp"

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

/// Returns a material with these facets, which are widened() along u if there is a strength.
template <class Model>
[[nodiscard]] MaterialDescription faceted(Model model, FacetDescription facets,
                                          const std::optional<TexturedNumber>& strength) {
    if (strength && (facets.alpha.texture || strength->texture))
        return BrushedModel(
            [model](const FacetDescription& of) {
                Model out = model;
                set_facets(of, out);
                return MaterialDescription(std::move(out));
            },
            std::move(facets.alpha), *strength);
    if (strength) {
        facets.alpha_v = facets.alpha;
        facets.alpha.value = widened(facets.alpha.value, strength->value);
    }
    set_facets(facets, model);
    return model;
}

/// A material whose anisotropic parts are rotated within the surface; see TangentRotation.
struct RotatedModel final : MaterialModel {
    RotatedModel(MaterialDescription of, TextureSpecificationPtr by, double and_angle)
        : base(std::move(of)), directions(std::move(by)), angle(and_angle) {}

    MaterialDescription base;
    TextureSpecificationPtr directions;  ///< null: none
    double angle;                        ///< in radians

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

/// Boundary that light passes, beside what its front reflects.
struct GlassDescription {
    double index;                ///< index of the inside
    double share;                ///< share of the light that passes, 0 to 1
    TexturedColor color;         ///< colour of the light that passes; its mean if a texture
    TexturedNumber alpha;        ///< roughness; its mean if a texture
    bool is_body = false;        ///< true: the light is refracted; false: the surface is a thin sheet
    glm::dvec3 absorption{0.0};  ///< absorption coefficient of the body, per unit of length
    FilmParameters film = {};    ///< film on the boundary
};

/// A material that reflects on its front and that light passes.
struct GlassModel final : MaterialModel {
    GlassModel(MaterialDescription reflecting, GlassDescription with)
        : reflection(std::move(reflecting)), glass(std::move(with)) {}

    MaterialDescription reflection;
    GlassDescription glass;

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

/// The sum of a plastic times a colour and of a mirror.
struct SpecularModel final : MaterialModel {
    SpecularModel(MaterialDescription of, TextureSpecificationPtr times, MaterialDescription and_mirror)
        : plastic(std::move(of)), share(std::move(times)), mirror(std::move(and_mirror)) {}

    MaterialDescription plastic;
    TextureSpecificationPtr share;  ///< factor of the plastic; not null
    MaterialDescription mirror;

    [[nodiscard]] MaterialPtr make(const MaterialMaker& maker) const override;
};

}  // namespace nicol::scene
