// SPDX-License-Identifier: MIT
#include "material/frames.hpp"

#include "polarization/lane_points.hpp"

namespace nicol {

SurfaceRotations<double> rotations_from_s_frames(const glm::dvec3& light, const glm::dvec3& viewer) {
    return rotations_from_s_frames(components(light), components(viewer));
}

Mueller in_rotated_frames(const Mueller& m, const SurfaceRotations<double>& rotations) {
    const auto& [in_cos2, in_sin2, out_cos2, out_sin2] = rotations;
    Mueller out = m;
    for (std::size_t p = 0; p < 4; ++p) {
        out(p, 1) = in_cos2 * m(p, 1) + in_sin2 * m(p, 2);
        out(p, 2) = in_cos2 * m(p, 2) - in_sin2 * m(p, 1);
    }
    for (std::size_t q = 0; q < 4; ++q) {
        const double m1 = out(1, q);
        const double m2 = out(2, q);
        out(1, q) = out_cos2 * m1 + out_sin2 * m2;
        out(2, q) = out_cos2 * m2 - out_sin2 * m1;
    }
    return out;
}

Mueller in_rotated_frames(double scale, const ReflectionBlock<double>& block,
                          const SurfaceRotations<double>& rotations) {
    Mueller out;
    in_rotated_frames(scale, block, rotations, 4,
                      [&](std::size_t i, double element) { out(i / 4, i % 4) = element; });
    return out;
}

}  // namespace nicol
