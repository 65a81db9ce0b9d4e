// SPDX-License-Identifier: MIT
#include "devices/mirrored_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include "geometry/perpendicular.hpp"

namespace nicol {
namespace {

glm::vec3 mirror(const glm::vec3& sight, const glm::vec3& normal) {
    return sight - 2 * glm::dot(sight, normal) * normal;
}

using Changes = std::array<glm::vec3, MirroredParts::kCount>;

// Returns the pixel with the mean and the second moments of the changes that its parts see, each as wide as
// its part of the even pixel. mirrored: unit direction that the shown point mirrors.
MirroredPixel covering(const Changes& seen, const MirroredPixel& even, const glm::vec3& mirrored) {
    constexpr float share = 1.0F / MirroredParts::kCount;
    MirroredPixel out;
    for (const glm::vec3& from : seen) out.shift += share * from;
    const glm::vec3 x(perpendicular(glm::dvec3(mirrored)));
    const std::array<glm::vec3, 2> axes{x, glm::cross(mirrored, x)};
    const auto across = [&](const glm::vec3& v) {
        return glm::vec2(glm::dot(v, axes[0]), glm::dot(v, axes[1]));
    };
    // Twelve times the covariance, because that of an even distribution along a step is a twelfth of its
    // square.
    glm::mat2 moments(0.0F);
    for (const glm::vec3& from : seen) {
        const glm::vec2 away = across(from - out.shift);
        moments += 12 * share * glm::outerProduct(away, away);
    }
    for (const glm::vec3& step : even.steps) {
        const glm::vec2 own = across(step) / static_cast<float>(MirroredParts::kAcross);
        moments += glm::outerProduct(own, own);
    }
    const float determinant = std::sqrt(std::max(0.0F, glm::determinant(moments)));
    const float trace = std::sqrt(moments[0][0] + moments[1][1] + 2 * determinant);
    if (!(trace > 0)) return out;
    const glm::mat2 root = (moments + glm::mat2(determinant)) / trace;
    for (std::size_t k = 0; k < 2; ++k) {
        const glm::vec2& step = root[static_cast<glm::length_t>(k)];
        out.steps[k] = step.x * axes[0] + step.y * axes[1];
    }
    return out;
}

}  // namespace

MirroredParts mirrored_parts(const glm::vec3& sight, const glm::vec3& normal,
                             std::span<const glm::vec3, MirroredParts::kCount> normals,
                             MirroredPixel& pixel) {
    const glm::vec3 mirrored = mirror(sight, normal);
    MirroredParts out;
    std::ranges::copy(normals, out.normals.begin());
    Changes seen;
    for (std::size_t part = 0; part < MirroredParts::kCount; ++part) {
        const glm::vec2 place = MirroredParts::middle(part);
        out.from[part] = pixel.shift + place.x * pixel.steps[0] + place.y * pixel.steps[1];
        seen[part] = out.from[part] + mirror(sight, normals[part]) - mirrored;
    }
    pixel = covering(seen, pixel, mirrored);
    return out;
}

}  // namespace nicol
