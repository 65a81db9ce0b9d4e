// SPDX-License-Identifier: MIT
#include "material/frames.hpp"

#include <glm/geometric.hpp>

namespace nicol {
namespace {

// From x along s (any length, perpendicular to the propagation z) to theta-hat.
FrameRotation to_theta_phi(const glm::dvec3& s, const glm::dvec3& z) {
    // Theta-hat and phi-hat times sin(theta): all lengths cancel in the ratios below.
    glm::dvec3 theta_hat(z.x * z.z, z.y * z.z, -(z.x * z.x + z.y * z.y));
    glm::dvec3 phi_hat(-z.y, z.x, 0);
    if (!(-theta_hat.z > 1e-280)) {
        theta_hat = {z.z, 0, 0};
        phi_hat = {0, 1, 0};
    }
    const double cosine = glm::dot(theta_hat, s);
    const double sine = -glm::dot(phi_hat, s);  // theta-hat . (z x s)
    const double norm = 1 / (cosine * cosine + sine * sine);
    return {(cosine * cosine - sine * sine) * norm, 2 * cosine * sine * norm};
}

void rotate_rows(Mueller& m, const FrameRotation& rotation) {
    for (std::size_t q = 0; q < 4; ++q) {
        const double m1 = m(1, q);
        const double m2 = m(2, q);
        m(1, q) = rotation.cos2 * m1 + rotation.sin2 * m2;
        m(2, q) = rotation.cos2 * m2 - rotation.sin2 * m1;
    }
}

}  // namespace

SurfaceRotations rotations_from_s_frames(const glm::dvec3& towards_light, const glm::dvec3& towards_viewer) {
    glm::dvec3 s = glm::cross(towards_light, towards_viewer);
    if (glm::dot(s, s) < 1e-24) {
        const glm::dvec3& v = towards_viewer;
        const bool vertical = v.x * v.x + v.y * v.y < 1e-24;
        s = vertical ? glm::dvec3(0, 1, 0) : glm::normalize(glm::dvec3(-v.y, v.x, 0));
    }
    return {to_theta_phi(s, -towards_light), to_theta_phi(s, towards_viewer)};
}

Mueller in_rotated_frames(const Mueller& m, const SurfaceRotations& rotations) {
    Mueller out = m;
    for (std::size_t p = 0; p < 4; ++p) {
        out(p, 1) = rotations.in.cos2 * m(p, 1) + rotations.in.sin2 * m(p, 2);
        out(p, 2) = rotations.in.cos2 * m(p, 2) - rotations.in.sin2 * m(p, 1);
    }
    rotate_rows(out, rotations.out);
    return out;
}

Mueller in_rotated_frames(double scale, const ReflectionBlock<double>& block,
                          const SurfaceRotations& rotations) {
    const double a = scale * block.a;
    const double b = scale * block.b;
    const double c = scale * block.c;
    const double d = scale * block.d;
    const auto& [ci, si] = rotations.in;
    Mueller out({a, b * ci, -b * si, 0, b, a * ci, -a * si, 0, 0, c * si, c * ci, -d, 0, d * si, d * ci, c});
    rotate_rows(out, rotations.out);
    return out;
}

}  // namespace nicol
