// SPDX-License-Identifier: MIT
// Reflection in one direction chosen by chance among those of a material's lobes.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "material/followed_terms.hpp"
#include "polarization/mueller.hpp"

namespace nicol {

/// Choice of a direction.
struct LobeChoice {
    double lobe;       ///< number of [0, 1) that chooses among the lobes
    glm::dvec2 facet;  ///< point of [0, 1)^2 that chooses a facet visible to the viewer
};

/// Cone of directions, in the surface's frame, that half of the choices are taken from, evenly.
struct AimedCone {
    glm::dvec3 axis;  ///< unit vector
    double cosine;    ///< of the angle between axis and edge, below 1
};

/// Returns the direction towards the light, in the surface's frame, and writes to out[channel] the matrix
/// from the radiance that arrives from there to the radiance that the followed terms reflect to the viewer,
/// weighted so that the mean over all choices is what they reflect. The matrices refer to the frames of
/// Material::evaluate(). Returns zero, and zero matrices, if the chosen facet reflects nothing to the viewer.
/// weights: of the layers for red, green and blue, or three equal ones. towards_viewer: a unit vector in the
/// surface's frame, above the horizon.
[[nodiscard]] glm::dvec3 sample_lobes(std::span<const FollowedLayer> layers,
                                      std::span<const glm::vec3> weights, const glm::dvec3& towards_viewer,
                                      const LobeChoice& choice, std::span<Mueller> out);

/// Returns the direction towards the viewer, in the surface's frame, and writes to out[channel] the matrix
/// from the light's power to that of the light that the followed terms send in all directions, weighted so
/// that the mean over all choices is what they send. Returns zero, and zero matrices, if nothing is sent in
/// the chosen direction. aim: where what is sent matters most. Everything else is as for sample_lobes().
[[nodiscard]] glm::dvec3 scatter_by_lobes(std::span<const FollowedLayer> layers,
                                          std::span<const glm::vec3> weights, const glm::dvec3& towards_light,
                                          const LobeChoice& choice, const std::optional<AimedCone>& aim,
                                          std::span<Mueller> out);

}  // namespace nicol
