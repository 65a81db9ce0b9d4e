// SPDX-License-Identifier: MIT
// Terms of materials that reflect other surfaces too sharply for the light that vertices keep, so that rays
// from pixels follow them.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "material/material.hpp"
#include "material/sampled_terms.hpp"

namespace nicol {

/// Narrowest lobe, in radians, that reflects bounced light at vertices well enough; measured.
inline constexpr double kWidestFollowedLobe = 0.25;
/// Least fraction of the light along the normal that followed lobes reflect. Weaker ones, such as the coats
/// of plastics, reflect too little of other surfaces to be worth rays.
inline constexpr double kLeastFollowedReflectance = 0.2;

/// Returns whether rays follow what surfaces of a material reflect of other surfaces, because the material or
/// one of its layers has lobes narrower than `widest` that reflect much.
[[nodiscard]] bool follows_lobes(const Material& material, double widest = kWidestFollowedLobe);
/// Returns whether rays follow a term of a layer of such a material: a term with a narrow or a sampled lobe.
[[nodiscard]] bool is_followed(const Material& layer, int term, SampledTerms sampled);

/// Returns whether all followed terms are sampled. If so, rays can show what glass sends to them, because no
/// harmonics hold light that passes glass straight.
[[nodiscard]] inline bool all_followed_sampled(SampledTerms sampled) {
    return sampled.kind == SampledTerms::anisotropic_narrow && sampled.narrowest >= kWidestFollowedLobe;
}

/// Followed terms of a layer.
struct FollowedLayer {
    struct Part {
        Lobe lobe;
        double reflectance;  ///< fraction of the light along the normal, for the choice of a lobe
    };
    const Material* material;
    std::vector<int> terms;
    std::vector<Part> parts;  ///< the terms' different lobes
};
/// Returns the terms of all layers, in their order, or of the material itself, that has(layer, term) returns
/// true for. The result refers to the material.
[[nodiscard]] std::vector<FollowedLayer> layers_with(const Material& material,
                                                     const std::function<bool(const Material&, int)>& has);
/// Returns the followed terms of all layers, in their order, or of the material itself. The result refers to
/// the material.
[[nodiscard]] std::vector<FollowedLayer> followed_layers(const Material& material, SampledTerms sampled);

}  // namespace nicol
