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

/// A direction, and its density per steradian; 0: no facet was chosen.
struct ChosenDirection {
    glm::dvec3 direction;
    double density;
};

// Chooses a direction by a facet that is visible from another one.
ChosenDirection choose(std::span<const FollowedLayer> layers, std::span<const glm::vec3> weights,
                       const glm::dvec3& from, const LobeChoice& choice) {
    constexpr ChosenDirection nothing{.direction = glm::dvec3(0.0), .density = 0};
    double all = 0;
    for_parts(layers, weights, [&](const Lobe&, double reflectance) { all += reflectance; });
    double below = choice.lobe * all;
    const Lobe* chosen = nullptr;
    for_parts(layers, weights, [&](const Lobe& lobe, double reflectance) {
        if (below >= 0 && reflectance > 0) chosen = &lobe;
        below -= reflectance;
    });
    if (chosen == nullptr) return nothing;

    // GGX facets stand for those of other distributions.
    const glm::dvec3 facet = visible_facet(chosen->alpha, from, choice.facet);
    const glm::dvec3 direction = 2 * glm::dot(from, facet) * facet - from;
    if (!(direction.z > 0)) return nothing;
    double density = 0;
    for_parts(layers, weights, [&](const Lobe& lobe, double reflectance) {
        density += reflectance / all * facet_density(Distribution::ggx, lobe.alpha, facet) *
                   facet_visibility(Distribution::ggx, lobe.alpha, from) / (4 * from.z);
    });
    if (!(density > 0)) return nothing;
    return {.direction = direction, .density = density};
}

// Adds the matrices of the followed terms of all layers.
void add_layers(std::span<const FollowedLayer> layers, std::span<const glm::vec3> weights,
                const glm::dvec3& towards_light, const glm::dvec3& towards_viewer, double scale,
                std::span<Mueller> out) {
    for (std::size_t l = 0; l < layers.size(); ++l) {
        const std::vector<int>& terms = layers[l].terms;
        if (terms.empty() || weights[l] == glm::vec3(0)) continue;
        add_terms(
            *layers[l].material, towards_light, towards_viewer, weights[l], scale,
            [&](int term) { return std::ranges::find(terms, term) != terms.end(); }, out);
    }
}

}  // namespace

glm::dvec3 sample_lobes(std::span<const FollowedLayer> layers, std::span<const glm::vec3> weights,
                        const glm::dvec3& towards_viewer, const LobeChoice& choice, std::span<Mueller> out) {
    std::ranges::fill(out, Mueller());
    const auto [towards_light, density] = choose(layers, weights, towards_viewer, choice);
    if (density > 0)
        add_layers(layers, weights, towards_light, towards_viewer, towards_light.z / density, out);
    return towards_light;
}

glm::dvec3 scatter_by_lobes(std::span<const FollowedLayer> layers, std::span<const glm::vec3> weights,
                            const glm::dvec3& towards_light, const LobeChoice& choice,
                            std::span<Mueller> out) {
    std::ranges::fill(out, Mueller());
    // Facets that are visible to the light, because by reciprocity both directions may be exchanged.
    const auto [towards_viewer, density] = choose(layers, weights, towards_light, choice);
    if (density > 0)
        add_layers(layers, weights, towards_light, towards_viewer, towards_viewer.z / density, out);
    return towards_viewer;
}

}  // namespace nicol
