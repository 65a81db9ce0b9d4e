// SPDX-License-Identifier: MIT
// Sums of the Mueller matrices of some terms of a material's layer.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "material/material.hpp"
#include "polarization/mueller.hpp"

namespace nicol {

/// Adds to out[channel] the matrices of the terms that has(term) names, times their weights, those of the
/// layer (red, green and blue, or three equal ones) and `scale`. Directions are in the surface's frame; the
/// matrices refer to the frames of Material::evaluate().
template <class Has>
void add_terms(const Material& layer, const glm::dvec3& towards_light, const glm::dvec3& towards_viewer,
               const glm::vec3& weights, double scale, const Has& has, std::span<Mueller> out) {
    thread_local std::vector<Mueller> terms;
    terms.resize(static_cast<std::size_t>(layer.terms()));
    layer.evaluate_terms(towards_light, towards_viewer, terms);
    for (int t = 0; t < layer.terms(); ++t) {
        if (!has(t)) continue;
        for (std::size_t c = 0; c < out.size(); ++c) {
            const auto of_layer = static_cast<double>(weights[out.size() == 3 ? static_cast<int>(c) : 0]);
            const double of_term = layer.weight(t, layer.channels() == 1 ? 0 : static_cast<int>(c));
            out[c] = out[c] + scale * of_layer * of_term * terms[static_cast<std::size_t>(t)];
        }
    }
}

}  // namespace nicol
