// SPDX-License-Identifier: MIT
#include "surfaces/rigid_motion.hpp"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

namespace nicol {
namespace {

double largest(const glm::dmat3& m) {
    double most = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) most = std::max(most, std::abs(m[i][j]));
    return most;
}

}  // namespace

glm::dmat3 rotate_in(const glm::dmat3& m) {
    // Newton's iteration for the polar decomposition. It halves the logarithms of the singular values until
    // they are small; then each step squares their error.
    constexpr int most_steps = 200;
    glm::dmat3 rotation = m / largest(m);
    if (glm::determinant(rotation) < 0) rotation = -rotation;
    for (int step = 0; step < most_steps; ++step) {
        const glm::dmat3 next = 0.5 * (rotation + glm::transpose(glm::inverse(rotation)));
        const double change = largest(next - rotation);
        rotation = next;
        if (change < 1e-15) break;
    }
    return rotation;
}

glm::dmat3 rotation_between(const glm::dmat4& before, const glm::dmat4& after) {
    const glm::dmat3 from(before), to(after);
    return from == to ? glm::dmat3(1.0) : rotate_in(to * glm::inverse(from));
}

std::optional<glm::dmat4> rigid_motion(const glm::dmat4& before, const glm::dmat4& after) {
    if (before == after) return glm::dmat4(1.0);
    const glm::dmat3 linear = glm::dmat3(after) * glm::inverse(glm::dmat3(before));
    const glm::dmat3 deviation = glm::transpose(linear) * linear - glm::dmat3(1.0);
    if (!(largest(deviation) < kRotationTolerance) || glm::determinant(linear) < 0) return std::nullopt;
    const glm::dmat3 rotation = rotation_between(before, after);
    glm::dmat4 motion(rotation);
    motion[3] = glm::dvec4(glm::dvec3(after[3]) - rotation * glm::dvec3(before[3]), 1);
    return motion;
}

glm::dmat4 inverse_motion(const glm::dmat4& motion) {
    const glm::dmat3 back = glm::transpose(glm::dmat3(motion));
    glm::dmat4 inverse(back);
    inverse[3] = glm::dvec4(-(back * glm::dvec3(motion[3])), 1);
    return inverse;
}

Projection in_axes(const Projection& projection, const glm::dmat4& to_world) {
    const glm::dmat3 back = glm::transpose(glm::dmat3(to_world));
    Projection out = projection;
    out.view.eye = back * (projection.view.eye - glm::dvec3(to_world[3]));
    out.view.forward = back * projection.view.forward;
    out.view.up = back * projection.view.up;
    out.view.right = back * projection.view.right;
    out.world_to_clip = projection.world_to_clip * to_world;
    return out;
}

}  // namespace nicol
