// SPDX-License-Identifier: MIT
// Rotations from frames along the s-axis to the theta-phi frames of Material, without trigonometric
// functions.
#pragma once

#include "polarization/fresnel.hpp"
#include "polarization/mueller.hpp"

namespace nicol {

/// A rotation of a frame about its z, as cosine and sine of twice the angle.
struct FrameRotation {
    double cos2 = 1;
    double sin2 = 0;
};

/// The rotations from frames with x along s to the theta-phi frames of the incident propagation
/// -towards_light and of towards_viewer.
struct SurfaceRotations {
    FrameRotation in;
    FrameRotation out;
};

/// Rotations for x along towards_light x towards_viewer, which is the s-axis of a facet between them. Where
/// they are parallel, x is an arbitrary perpendicular direction.
[[nodiscard]] SurfaceRotations rotations_from_s_frames(const glm::dvec3& towards_light,
                                                       const glm::dvec3& towards_viewer);

/// m in rotated frames.
[[nodiscard]] Mueller in_rotated_frames(const Mueller& m, const SurfaceRotations& rotations);

/// scale times the block in rotated frames.
[[nodiscard]] Mueller in_rotated_frames(double scale, const ReflectionBlock<double>& block,
                                        const SurfaceRotations& rotations);

}  // namespace nicol
