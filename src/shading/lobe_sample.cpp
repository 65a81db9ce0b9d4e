// SPDX-License-Identifier: MIT
#include "shading/lobe_sample.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "material/microfacet.hpp"
#include "shading/weighted_terms.hpp"

namespace nicol {
namespace {

double mean(const glm::vec3& weights) {
    return double{weights.x + weights.y + weights.z} / 3;
}

// Calls visit(part, reflectance) for the lobes of all layers.
template <class Visit>
void for_parts(std::span<const FollowedLayer> layers, std::span<const glm::vec3> weights,
               const Visit& visit) {
    for (std::size_t l = 0; l < layers.size(); ++l)
        for (const FollowedLayer::Part& part : layers[l].parts)
            visit(part.lobe, mean(weights[l]) * part.reflectance);
}

}  // namespace

glm::dvec3 sample_lobes(std::span<const FollowedLayer> layers, std::span<const glm::vec3> weights,
                        const glm::dvec3& towards_viewer, const LobeChoice& choice, std::span<Mueller> out) {
    std::ranges::fill(out, Mueller());
    double all = 0;
    for_parts(layers, weights, [&](const Lobe&, double reflectance) { all += reflectance; });
    if (!(all > 0)) return glm::dvec3(0.0);
    double below = choice.lobe * all;
    const Lobe* chosen = nullptr;
    for_parts(layers, weights, [&](const Lobe& lobe, double reflectance) {
        if (below >= 0 && reflectance > 0) chosen = &lobe;
        below -= reflectance;
    });

    // GGX facets stand for those of other distributions.
    const glm::dvec3 facet = visible_facet(chosen->alpha, towards_viewer, choice.facet);
    const glm::dvec3 towards_light = 2 * glm::dot(towards_viewer, facet) * facet - towards_viewer;
    if (!(towards_light.z > 0)) return glm::dvec3(0.0);
    double density = 0;
    for_parts(layers, weights, [&](const Lobe& lobe, double reflectance) {
        density += reflectance / all * facet_density(Distribution::ggx, lobe.alpha, facet) *
                   facet_visibility(Distribution::ggx, lobe.alpha, towards_viewer) / (4 * towards_viewer.z);
    });
    if (!(density > 0)) return glm::dvec3(0.0);

    for (std::size_t l = 0; l < layers.size(); ++l) {
        const std::vector<int>& terms = layers[l].terms;
        if (terms.empty() || weights[l] == glm::vec3(0)) continue;
        add_terms(
            *layers[l].material, towards_light, towards_viewer, weights[l], towards_light.z / density,
            [&](int term) { return std::ranges::find(terms, term) != terms.end(); }, out);
    }
    return towards_light;
}

}  // namespace nicol
