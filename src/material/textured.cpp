// SPDX-License-Identifier: MIT
#include "material/textured.hpp"

#include <functional>
#include <utility>

#include "material/mixture.hpp"

namespace nicol {
namespace {

MaterialPtr times(const MaterialPtr& material, const TexturePtr& reflectance) {
    return reflectance ? scaled(material, reflectance) : material;
}

MaterialPtr at_roughness(const std::function<MaterialPtr(double alpha)>& make, double alpha,
                         const TexturePtr& texture) {
    return texture ? with_roughness(make, texture) : make(alpha);
}

TexturePtr texture_or(const TexturePtr& texture, double number) {
    return texture ? texture : constant_texture(glm::vec4(static_cast<float>(number)), 1);
}

}  // namespace

MaterialPtr pplastic(const PplasticParameters& parameters, const PlasticTextures& textures) {
    if (!textures.diffuse_reflectance && !textures.specular_reflectance && !textures.alpha)
        return pplastic(parameters);
    // The base does not depend on the roughness of the boundary above it.
    PplasticParameters base = parameters;
    base.specular_reflectance = {0};
    if (textures.diffuse_reflectance) base.diffuse_reflectance = {1};
    PplasticParameters boundary = parameters;
    boundary.diffuse_reflectance = {0};
    if (textures.specular_reflectance) boundary.specular_reflectance = {1};

    const auto make_boundary = [boundary](double alpha) {
        PplasticParameters of_alpha = boundary;
        of_alpha.alpha = alpha;
        return pplastic(of_alpha);
    };
    return sum(
        times(pplastic(base), textures.diffuse_reflectance),
        times(at_roughness(make_boundary, parameters.alpha, textures.alpha), textures.specular_reflectance));
}

MaterialPtr plastic(const PlasticParameters& parameters, const PlasticTextures& textures) {
    if (!textures.diffuse_reflectance && !textures.specular_reflectance && !textures.alpha)
        return plastic(parameters);
    const auto make_base = [&](double alpha) {
        PlasticParameters base = parameters;
        base.alpha = alpha;
        base.specular_reflectance = {0};
        if (!textures.diffuse_reflectance) return plastic(base);
        base.diffuse_reflectance = {1};
        const MaterialPtr white = plastic(base);
        if (!base.nonlinear) return scaled(white, textures.diffuse_reflectance);
        // What returns to a white base makes it 1 / (1 - returned) times as bright.
        return scaled_again(white, textures.diffuse_reflectance, 1 - 1 / white->weight(0, 0));
    };
    const auto make_boundary = [&](double alpha) {
        PlasticParameters boundary = parameters;
        boundary.alpha = alpha;
        boundary.diffuse_reflectance = {0};
        if (textures.specular_reflectance) boundary.specular_reflectance = {1};
        return plastic(boundary);
    };
    return sum(
        at_roughness(make_base, parameters.alpha, textures.alpha),
        times(at_roughness(make_boundary, parameters.alpha, textures.alpha), textures.specular_reflectance));
}

MaterialPtr rough_conductor(const RoughConductorParameters& parameters, const ConductorTextures& textures) {
    RoughConductorParameters facets = parameters;
    if (textures.specular_reflectance) facets.specular_reflectance = {1};
    const auto make_facets = [facets](double alpha, double alpha_v) {
        RoughConductorParameters of_alpha = facets;
        of_alpha.alpha = alpha;
        of_alpha.alpha_v = alpha_v;
        return rough_conductor(of_alpha);
    };
    const bool alike = textures.alpha_v ? textures.alpha_v == textures.alpha : parameters.alpha_v == 0;
    MaterialPtr material;
    if (alike) {
        material = at_roughness([&](double alpha) { return make_facets(alpha, 0); }, parameters.alpha,
                                textures.alpha);
    } else if (textures.alpha || textures.alpha_v) {
        material = with_roughness(make_facets, texture_or(textures.alpha, parameters.alpha),
                                  texture_or(textures.alpha_v, parameters.alpha_v));
    } else {
        material = rough_conductor(facets);
    }
    return times(material, textures.specular_reflectance);
}

}  // namespace nicol
