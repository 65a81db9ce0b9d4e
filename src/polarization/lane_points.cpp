// SPDX-License-Identifier: MIT
#include "polarization/lane_points.hpp"

namespace nicol {

LanePoints lane_points(std::span<const glm::vec3> from) {
    LanePoints to;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::vec3& v = from[i < from.size() ? i : 0];
        to.x.value[i] = static_cast<double>(v.x);
        to.y.value[i] = static_cast<double>(v.y);
        to.z.value[i] = static_cast<double>(v.z);
    }
    return to;
}

}  // namespace nicol
