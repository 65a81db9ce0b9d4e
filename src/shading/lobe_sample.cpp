// SPDX-License-Identifier: MIT
#include "shading/lobe_sample.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "material/microfacet.hpp"
#include "polarization/stokes.hpp"
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

// Part of the choices that are taken from a cone.
constexpr double kAimed = 0.5;

// Returns the direction of a cone that a point of [0, 1)^2 chooses.
glm::dvec3 in_cone(const AimedCone& cone, const glm::dvec2& point) {
    const double cosine = 1 - point.x * (1 - cone.cosine);
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double phi = 2 * std::numbers::pi * point.y;
    const Frame frame = theta_phi_frame(cone.axis);
    return sine * (std::cos(phi) * frame[0] + std::sin(phi) * frame[1]) + cosine * cone.axis;
}

// Returns the density per steradian of in_cone().
double cone_density(const AimedCone& cone, const glm::dvec3& direction) {
    if (glm::dot(cone.axis, direction) < cone.cosine) return 0;
    return 1 / (2 * std::numbers::pi * (1 - cone.cosine));
}

// Chooses a direction by a facet that is visible from another one, or in a cone.
ChosenDirection choose(std::span<const FollowedLayer> layers, std::span<const glm::vec3> weights,
                       const glm::dvec3& from, const LobeChoice& choice,
                       const std::optional<AimedCone>& aim = std::nullopt) {
    constexpr ChosenDirection nothing{.direction = glm::dvec3(0.0), .density = 0};
    const double aimed = aim ? kAimed : 0;
    double all = 0;
    for_parts(layers, weights, [&](const Lobe&, double reflectance) { all += reflectance; });
    if (!(all > 0)) return nothing;
    glm::dvec3 direction(0.0), facet(0.0);
    if (choice.lobe < aimed) {
        direction = in_cone(*aim, choice.facet);
        facet = glm::normalize(from + direction);
    } else {
        double below = (choice.lobe - aimed) / (1 - aimed) * all;
        const Lobe* chosen = nullptr;
        for_parts(layers, weights, [&](const Lobe& lobe, double reflectance) {
            if (below >= 0 && reflectance > 0) chosen = &lobe;
            below -= reflectance;
        });
        if (chosen == nullptr) return nothing;
        // GGX facets stand for those of other distributions.
        facet = visible_facet(chosen->alpha, from, choice.facet);
        direction = 2 * glm::dot(from, facet) * facet - from;
    }
    if (!(direction.z > 0)) return nothing;
    double density = 0;
    for_parts(layers, weights, [&](const Lobe& lobe, double reflectance) {
        density += reflectance / all * facet_density(Distribution::ggx, lobe.alpha, facet) *
                   facet_visibility(Distribution::ggx, lobe.alpha, from) / (4 * from.z);
    });
    if (aim) density = (1 - aimed) * density + aimed * cone_density(*aim, direction);
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
                            const std::optional<AimedCone>& aim, std::span<Mueller> out) {
    std::ranges::fill(out, Mueller());
    // Facets that are visible to the light, because by reciprocity both directions may be exchanged.
    const auto [towards_viewer, density] = choose(layers, weights, towards_light, choice, aim);
    if (density > 0)
        add_layers(layers, weights, towards_light, towards_viewer, towards_viewer.z / density, out);
    return towards_viewer;
}

}  // namespace nicol
