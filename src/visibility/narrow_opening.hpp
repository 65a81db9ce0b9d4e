// SPDX-License-Identifier: MIT
// Correction of truncated visibility where little of the sky is seen.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "visibility/visibility.hpp"

namespace nicol {

/// Returns the factor by which coefficients of VisibilityHarmonics have to be multiplied so that, up to
/// `order`, a matt surface reflects even light as much as the visible directions say. 1 unless little light
/// arrives: the missing orders matter little elsewhere. zonal: coefficients (l, 0) for l = 0, 2, 4 ... up to
/// `order`.
[[nodiscard]] float narrow_opening_factor(const DirectionSet& directions, const Visibility& visibility,
                                          std::size_t vertex, const glm::vec3& normal,
                                          std::span<const float> zonal);

/// Multiplies a vertex's coefficients by the factor for this order. Coefficient psh_index(l, m) is at
/// stride times this index.
void scale_narrow_opening(const DirectionSet& directions, const Visibility& visibility, std::size_t vertex,
                          const glm::vec3& normal, int order, std::span<float> coefficients,
                          std::size_t stride = 1);

}  // namespace nicol
