// SPDX-License-Identifier: MIT
#include "material/followed_terms.hpp"

#include <algorithm>
#include <numbers>

#include "material/spatial_variation.hpp"

namespace nicol {
namespace {

bool narrow(const Material& material, int term, double widest = kWidestFollowedLobe) {
    return material.matrix(0) == nullptr && !material.smooth(term) && material.lobe_width(term) < widest;
}

// Returns the fraction of the light along the normal that a term reflects, if its facets are those of its
// lobe.
double reflectance(const Material& material, int term) {
    const glm::dvec3 normal(0, 0, 1);
    const glm::dvec2 alpha = material.lobe(term).alpha;
    double weight = 0;
    for (int c = 0; c < material.channels(); ++c) weight += material.weight(term, c) / material.channels();
    return 4 * std::numbers::pi * alpha.x * alpha.y * weight * material.evaluate(term, normal, normal)(0, 0);
}

bool follows(const Material& layer, double widest) {
    double sum = 0;
    for (int t = 0; t < layer.terms(); ++t)
        if (narrow(layer, t, widest)) sum += reflectance(layer, t);
    return sum >= kLeastFollowedReflectance;
}

FollowedLayer layer_with(const Material& layer, const std::function<bool(const Material&, int)>& has) {
    FollowedLayer out{.material = &layer, .terms = {}, .parts = {}};
    for (int t = 0; t < layer.terms(); ++t) {
        if (!has(layer, t)) continue;
        out.terms.push_back(t);
        const Lobe lobe = layer.lobe(t);
        auto part = std::ranges::find(out.parts, lobe, &FollowedLayer::Part::lobe);
        if (part == out.parts.end()) part = out.parts.insert(part, {.lobe = lobe, .reflectance = 0});
        part->reflectance += reflectance(layer, t);
    }
    return out;
}

}  // namespace

bool follows_lobes(const Material& material, double widest) {
    const SpatialVariation* const variation = material.variation();
    if (variation == nullptr) return follows(material, widest);
    return std::ranges::any_of(
        variation->layers, [widest](const MaterialLayer& layer) { return follows(*layer.material, widest); });
}

bool is_followed(const Material& layer, int term, SampledTerms sampled) {
    return narrow(layer, term) || (!layer.smooth(term) && is_sampled(layer, term, sampled));
}

std::vector<FollowedLayer> layers_with(const Material& material,
                                       const std::function<bool(const Material&, int)>& has) {
    const SpatialVariation* const variation = material.variation();
    if (variation == nullptr) return {layer_with(material, has)};
    std::vector<FollowedLayer> out;
    out.reserve(variation->layers.size());
    for (const MaterialLayer& layer : variation->layers) out.push_back(layer_with(*layer.material, has));
    return out;
}

std::vector<FollowedLayer> followed_layers(const Material& material, SampledTerms sampled) {
    return layers_with(material,
                       [=](const Material& layer, int term) { return is_followed(layer, term, sampled); });
}

}  // namespace nicol
