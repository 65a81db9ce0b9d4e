// SPDX-License-Identifier: MIT
#include "material/material.hpp"

namespace nicol {

void Material::evaluate_terms(const glm::dvec3& towards_light, const glm::dvec3& towards_viewer,
                              std::span<Mueller> out) const {
    for (int t = 0; t < terms(); ++t)
        out[static_cast<std::size_t>(t)] = evaluate(t, towards_light, towards_viewer);
}

const IsotropicMatrix* Material::matrix(int) const {
    return nullptr;
}

Mueller evaluate(const Material& material, int channel, const glm::dvec3& towards_light,
                 const glm::dvec3& towards_viewer) {
    Mueller sum;
    for (int t = 0; t < material.terms(); ++t) {
        const double weight = material.weight(t, channel);
        if (weight != 0) sum = sum + weight * material.evaluate(t, towards_light, towards_viewer);
    }
    return sum;
}

}  // namespace nicol
