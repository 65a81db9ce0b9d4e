// SPDX-License-Identifier: MIT
// Rotations from frames along the s-axis to the theta-phi frames of Material, without trigonometric
// functions.
#pragma once

#include <complex>

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

/// Fresnel's reflection [[a, b, 0, 0], [b, a, 0, 0], [0, 0, c, -d], [0, 0, d, c]] in s-frames.
struct ReflectionBlock {
    double a, b, c, d;
};

/// The Fresnel reflection as these four numbers; fast for real eta.
[[nodiscard]] ReflectionBlock reflection_block(double cos_incident, std::complex<double> eta);

/// scale times the block in rotated frames.
[[nodiscard]] Mueller in_rotated_frames(double scale, const ReflectionBlock& block,
                                        const SurfaceRotations& rotations);

}  // namespace nicol
