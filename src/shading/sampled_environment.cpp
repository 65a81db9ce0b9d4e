// SPDX-License-Identifier: MIT
#include "shading/sampled_environment.hpp"

#include <limits>

#include "shading/rotated_light.hpp"

namespace nicol {
void SampledEnvironment::look_up(bool whole, const Lanes& variances, LaneLight& out) const {
    look_up_rotated(to_points_, scale_, out, [&] { (whole ? whole_ : rest_)->look_up(variances, out); });
    out.points = (std::uint32_t{1} << kLanes) - 1;
    out.distance.value.fill(std::numeric_limits<float>::infinity());
}

}  // namespace nicol
