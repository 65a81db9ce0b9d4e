// SPDX-License-Identifier: MIT
#include "polarization/views.hpp"

namespace nicol {

LaneSights lane_sights(Views views, std::span<const glm::vec3> positions) {
    LaneSights out;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const std::size_t own = i < positions.size() ? i : 0;
        const Viewpoint& view = views.at(own);
        const glm::dvec3 towards = view.towards(glm::dvec3(positions[own]));
        put(out.towards, i, glm::vec3(towards));
        put(out.x, i, glm::vec3(view.frame(towards)[0]));
    }
    return out;
}

}  // namespace nicol
