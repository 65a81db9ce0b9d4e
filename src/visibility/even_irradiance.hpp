// SPDX-License-Identifier: MIT
// Correction of truncated visibility by the irradiance of even light.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "visibility/hidden_light.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// Returns the irradiance over pi that a light's coefficient (l, 0) of 1 has on a surface with the normal z,
/// for l = 0, 2, 4 ... up to the order.
[[nodiscard]] std::vector<double> zonal_irradiance(int order);

/// Scales a vertex's coefficients of VisibilityHarmonics so that, truncated at an order, a matt surface
/// reflects even light exactly as much as the visible directions say.
class EvenIrradiance {
public:
    /// directions: must outlive the object.
    EvenIrradiance(const DirectionSet& directions, int order);

    /// Multiplies the coefficients of a vertex by one factor, in 0.1 .. 3. Coefficient psh_index(l, m) is at
    /// stride times this index.
    void restore(const Visibility& visibility, std::size_t vertex, const glm::vec3& unit_normal,
                 std::span<float> coefficients, std::size_t stride = 1) const;

private:
    HiddenLight hidden_;
    std::vector<double> irradiance_;  // see zonal_irradiance()
};

}  // namespace nicol
