// SPDX-License-Identifier: MIT
#include "polarization/lane_camera.hpp"

namespace nicol {
namespace {

std::array<double, 3> components(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

}  // namespace

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

LaneCamera lane_camera(const Viewpoint& view) {
    return {.orthographic = view.orthographic,
            .eye = components(view.eye),
            .backward = components(-view.forward),
            .up = components(view.up),
            .right = components(view.right)};
}

}  // namespace nicol
