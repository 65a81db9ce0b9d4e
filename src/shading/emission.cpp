// SPDX-License-Identifier: MIT
#include "shading/emission.hpp"

#include <glm/geometric.hpp>

namespace nicol {

void add_emitted(const Emission& emission, const glm::dvec3& axis, const Views& views,
                 std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                 std::span<const TexturePoint> points, std::span<const std::span<glm::vec4>> out) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Viewpoint& view = views.at(i);
        const glm::dvec3 propagation = view.towards(glm::dvec3(positions[i]));
        if (!(glm::dot(propagation, glm::dvec3(normals[i])) > 0)) continue;
        const Stokes state = stokes_in(view.frame(propagation), emission.state, axis);
        const glm::vec4 texel = emission.texture != nullptr ? emission.texture->at(points[i]) : glm::vec4(1);
        for (std::size_t c = 0; c < out.size(); ++c)
            out[c][i] += glm::vec4(
                textured_value(emission.radiance, emission.texture, texel, static_cast<int>(c)) * state);
    }
}

}  // namespace nicol
