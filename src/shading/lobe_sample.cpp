// SPDX-License-Identifier: MIT
#include "shading/lobe_sample.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "material/microfacet.hpp"

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

    thread_local std::vector<Mueller> terms;
    for (std::size_t l = 0; l < layers.size(); ++l) {
        const FollowedLayer& layer = layers[l];
        if (layer.terms.empty() || weights[l] == glm::vec3(0)) continue;
        terms.resize(static_cast<std::size_t>(layer.material->terms()));
        layer.material->evaluate_terms(towards_light, towards_viewer, terms);
        for (const int term : layer.terms)
            for (std::size_t c = 0; c < out.size(); ++c) {
                const int channel = layer.material->channels() == 1 ? 0 : static_cast<int>(c);
                const double factor =
                    layer.material->weight(term, channel) * towards_light.z / density *
                    static_cast<double>(weights[l][out.size() == 3 ? static_cast<int>(c) : 0]);
                out[c] = out[c] + factor * terms[static_cast<std::size_t>(term)];
            }
    }
    return towards_light;
}

}  // namespace nicol
