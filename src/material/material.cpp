// SPDX-License-Identifier: MIT
#include "material/material.hpp"

#include <glm/geometric.hpp>

#include "simd/work_space.hpp"

namespace nicol {

void Material::evaluate_terms(const glm::dvec3& towards_light, const glm::dvec3& towards_viewer,
                              std::span<Mueller> out) const {
    for (int t = 0; t < terms(); ++t)
        out[static_cast<std::size_t>(t)] = evaluate(t, towards_light, towards_viewer);
}

void Material::evaluate_lanes(const LaneVectors& towards_light, const LaneVectors& towards_viewer,
                              std::size_t, std::span<LaneMueller> out) const {
    const auto direction = [](const LaneVectors& of, std::size_t i) {
        return glm::normalize(glm::dvec3(of.x[i], of.y[i], of.z[i]));
    };
    const std::span<Mueller> matrices = work_space<Material, Mueller>(static_cast<std::size_t>(terms()));
    for (std::size_t i = 0; i < kLanes; ++i) {
        evaluate_terms(direction(towards_light, i), direction(towards_viewer, i), matrices);
        for (std::size_t t = 0; t < matrices.size(); ++t)
            for (std::size_t e = 0; e < 16; ++e)
                out[t].m[e][i] = static_cast<float>(matrices[t](e / 4, e % 4));
    }
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
