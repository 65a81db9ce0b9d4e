// SPDX-License-Identifier: MIT
#include "render/used_normals.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "polarization/stokes.hpp"
#include "visibility/visibility.hpp"

namespace nicol {
namespace {

// Angle, in radians, up to which visibility turns with its vertex. Beside a floor, light from a band of half
// this height is then taken for light from above it.
constexpr double kMostTurn = 0.25;

// Returns whether the frame of a vertex has turned too far. Near the poles of the frames' axes, frames turn
// farther than normals.
bool turned_far(const glm::vec3& before, const glm::vec3& now) {
    const Frame a = theta_phi_frame(glm::normalize(glm::dvec3(before)));
    const Frame b = theta_phi_frame(glm::normalize(glm::dvec3(now)));
    const double trace = glm::dot(a[0], b[0]) + glm::dot(a[1], b[1]) + glm::dot(a[2], b[2]);
    return (trace - 1) / 2 < std::cos(kMostTurn);
}

}  // namespace

void UsedNormals::reset(std::span<const glm::vec3> normals) {
    normals_.assign(normals.begin(), normals.end());
}

std::vector<std::uint8_t> UsedNormals::follow(std::span<const glm::vec3> normals,
                                              std::span<std::uint32_t> former,
                                              const std::function<bool(std::uint32_t)>& deformed) {
    std::vector<std::uint8_t> same(normals.size(), 1);
    std::vector<glm::vec3> used(normals.begin(), normals.end());
    for (std::uint32_t v = 0; v < normals.size(); ++v) {
        if (former[v] == kNoVertex) continue;
        const glm::vec3& before = normals_[former[v]];
        same[v] = deformed(v) ? 0 : 1;
        if (same[v] == 0 && turned_far(before, normals[v]))
            former[v] = kNoVertex;
        else
            used[v] = before;
    }
    normals_ = std::move(used);
    return same;
}

}  // namespace nicol
