// SPDX-License-Identifier: MIT
#include "shading/shine.hpp"

#include <algorithm>

#include "material/reflectance.hpp"

namespace nicol {

void add_shine(const Emission& emission, const glm::dvec3& axis, const Viewpoint& view,
               std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
               std::span<const glm::vec2> texcoords, std::span<const std::span<glm::vec4>> out) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const glm::dvec3 propagation = view.towards(glm::dvec3(positions[i]));
        if (!(glm::dot(propagation, glm::dvec3(normals[i])) > 0)) continue;
        Stokes state = emission.state.stokes();
        if (emission.state.polarized()) {
            state =
                rotated(state, angle_between(polarization_frame(axis, propagation), view.frame(propagation)));
        }
        glm::vec4 color(1);
        if (emission.texture != nullptr) color = emission.texture->at({.uv = texcoords[i]});
        for (std::size_t c = 0; c < out.size(); ++c) {
            const int channel = emission.radiance.size() == 1 ? 0 : static_cast<int>(c);
            const double radiance =
                of_channel(emission.radiance, channel) *
                static_cast<double>(color[static_cast<glm::length_t>(std::min<std::size_t>(c, 2))]);
            out[c][i] += glm::vec4(radiance * state);
        }
    }
}

}  // namespace nicol
