// SPDX-License-Identifier: MIT
#include "devices/mirrored_parts.hpp"

#include <array>
#include <glm/geometric.hpp>

#include "test.hpp"

using namespace nicol;

namespace {

constexpr std::size_t count = MirroredParts::kCount;
const glm::vec3 sight = glm::normalize(glm::vec3(0.3F, 0.2F, -1));
const glm::vec3 normal(0, 0, 1);
const glm::vec3 mirrored(sight.x, sight.y, -sight.z);

/// Returns a pixel whose steps are across the mirrored direction.
MirroredPixel some_pixel() {
    const glm::vec3 x = glm::normalize(glm::cross(mirrored, glm::vec3(0, 1, 0)));
    const glm::vec3 y = glm::cross(mirrored, x);
    return {.shift = 0.01F * x, .steps = {0.2F * x + 0.05F * y, 0.1F * y}};
}

/// Returns the second moment of the pixel along a direction.
float moment(const MirroredPixel& pixel, const glm::vec3& along) {
    float out = 0;
    for (const glm::vec3& step : pixel.steps) out += glm::dot(step, along) * glm::dot(step, along);
    return out;
}

}  // namespace

TEST_CASE("parts with the pixel's own normal have the moments of the pixel") {
    std::array<glm::vec3, count> normals;
    normals.fill(normal);
    const MirroredPixel before = some_pixel();
    MirroredPixel pixel = before;
    const MirroredParts parts = mirrored_parts(sight, normal, normals, pixel);
    CHECK(glm::distance(parts.from[0], before.shift - 0.375F * (before.steps[0] + before.steps[1])) < 1e-6F);
    CHECK(glm::distance(parts.from[7], before.shift + 0.375F * before.steps[0] - 0.125F * before.steps[1]) <
          1e-6F);
    CHECK(glm::distance(pixel.shift, before.shift) < 1e-6F);
    for (const glm::vec3& along : {before.steps[0], before.steps[1], before.steps[0] + before.steps[1]})
        CHECK(std::abs(moment(pixel, along) / moment(before, along) - 1) < 1e-4F);
}

TEST_CASE("parts have their own normals, and widen the pixel by what these mirror") {
    std::array<glm::vec3, count> normals;
    for (std::size_t k = 0; k < count; ++k)
        normals[k] = glm::normalize(glm::vec3(k % 2 == 0 ? 0.2F : -0.2F, 0, 1));
    MirroredPixel pixel{};
    const MirroredParts parts = mirrored_parts(sight, normal, normals, pixel);
    std::array<glm::vec3, count> seen;
    glm::vec3 mean(0);
    for (std::size_t k = 0; k < count; ++k) {
        CHECK(parts.normals[k] == normals[k]);
        CHECK(glm::length(parts.from[k]) < 1e-6F);
        seen[k] = sight - 2 * glm::dot(sight, normals[k]) * normals[k] - mirrored;
        mean += seen[k] / static_cast<float>(count);
    }
    CHECK(glm::distance(pixel.shift, mean) < 1e-6F);
    // Two equally frequent directions have the variance of half their distance, squared.
    const glm::vec3 apart = seen[0] - seen[1];
    const glm::vec3 along = glm::normalize(apart - glm::dot(apart, mirrored) * mirrored);
    CHECK(std::abs(moment(pixel, along) / (3 * glm::dot(apart, along) * glm::dot(apart, along)) - 1) < 1e-3F);
}

TEST_CASE("places lie in the parts whose middles they are nearest to") {
    for (std::size_t part = 0; part < count; ++part) {
        CHECK(MirroredParts::at(MirroredParts::middle(part)) == part);
        CHECK(MirroredParts::at(MirroredParts::middle(part) + glm::vec2(0.12F, -0.12F)) == part);
    }
    CHECK(MirroredParts::at(glm::vec2(0.5F)) == count - 1);
    CHECK(MirroredParts::at(glm::vec2(-0.5F)) == 0);
}
