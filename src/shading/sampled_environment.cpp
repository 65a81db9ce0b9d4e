// SPDX-License-Identifier: MIT
#include "shading/sampled_environment.hpp"

#include <limits>

namespace nicol {
void SampledEnvironment::look_up(bool whole, const Lanes& solid_angles, LaneLight& out) const {
    const auto of_lane = [](const LaneVectors& v, std::size_t i) {
        return glm::vec3(v.x[i], v.y[i], v.z[i]);
    };
    const LaneVectors directions = out.towards;
    for (std::size_t i = 0; i < kLanes; ++i) put(out.towards, i, to_environment_ * of_lane(directions, i));
    (whole ? whole_ : rest_)->look_up(solid_angles, out);
    out.towards = directions;
    out.points = (std::uint32_t{1} << kLanes) - 1;
    for (std::size_t i = 0; i < kLanes; ++i) {
        put(out.x, i, of_lane(out.x, i) * to_environment_);
        out.distance[i] = std::numeric_limits<float>::infinity();
    }
    for (std::array<Lanes, 4>& stokes : out.irradiance)
        for (std::size_t p = 0; p < out.components; ++p)
            for (std::size_t i = 0; i < kLanes; ++i) stokes[p][i] *= scale_;
}

}  // namespace nicol
