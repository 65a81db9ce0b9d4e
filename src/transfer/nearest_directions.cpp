// SPDX-License-Identifier: MIT
#include "transfer/nearest_directions.hpp"

#include <algorithm>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace nicol {
namespace {

constexpr std::size_t kAcross = 16;  // cells along each edge of the cube

// Returns the unit vector to the middle of a cell.
glm::vec3 middle_of(std::size_t cell) {
    const auto place = [](std::size_t k) {
        return (static_cast<float>(k) + 0.5F) * 2 / static_cast<float>(kAcross) - 1;
    };
    const std::size_t face = cell / (kAcross * kAcross);
    const auto axis = static_cast<glm::length_t>(face / 2);
    glm::vec3 out;
    out[axis] = face % 2 == 0 ? 1.0F : -1.0F;
    out[(axis + 1) % 3] = place(cell / kAcross % kAcross);
    out[(axis + 2) % 3] = place(cell % kAcross);
    return glm::normalize(out);
}

}  // namespace

NearestDirections::NearestDirections(const DirectionSet& directions) : nearest_(6 * kAcross * kAcross) {
    // Neighbours in the set are neighbours on the sphere, so that some of them are spread evenly, too.
    constexpr std::size_t enough = 2048;
    const std::size_t step = std::max<std::size_t>(1, directions.size() / enough);
    for (std::size_t cell = 0; cell < nearest_.size(); ++cell) {
        const glm::vec3 middle = middle_of(cell);
        float best = -2;
        for (std::size_t d = 0; d < directions.size(); d += step) {
            const float cosine = glm::dot(middle, directions.directions()[d]);
            if (cosine > best) {
                best = cosine;
                nearest_[cell] = static_cast<std::uint32_t>(d);
            }
        }
    }
}

std::uint32_t NearestDirections::of(const glm::vec3& direction) const {
    const glm::vec3 size = glm::abs(direction);
    const glm::length_t smaller = size.y >= size.z ? 1 : 2;
    const glm::length_t axis = size.x >= size.y && size.x >= size.z ? 0 : smaller;
    const auto along = [&](glm::length_t k) {
        const float at = (direction[k] / size[axis] + 1) * 0.5F * static_cast<float>(kAcross);
        return std::min(static_cast<std::size_t>(std::max(at, 0.0F)), kAcross - 1);
    };
    const std::size_t face = 2 * static_cast<std::size_t>(axis) + (direction[axis] < 0 ? 1 : 0);
    return nearest_[(face * kAcross + along((axis + 1) % 3)) * kAcross + along((axis + 2) % 3)];
}

}  // namespace nicol
