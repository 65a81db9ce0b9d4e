// SPDX-License-Identifier: MIT
#include "shading/normal_variation.hpp"

#include <glm/geometric.hpp>

#include "test.hpp"

using namespace nicol;

namespace {

TexturePtr random_texture(std::mt19937& random) {
    TextureImage image{.width = 16, .height = 16, .channels = 3};
    std::uniform_real_distribution<float> value(0, 1);
    for (int i = 0; i < 3 * 16 * 16; ++i) image.values.push_back(value(random));
    return image_texture(std::move(image));
}

}  // namespace

TEST_CASE("on the back a map mirrors the front's normal, or reverses it around a two-sided material") {
    const glm::vec3 leaning = glm::normalize(glm::vec3(0.5, -0.3, 1));
    const TexturePtr texture = constant_texture(glm::vec4(0.5F + 0.5F * leaning, 1), 3);
    const TextureAxes axes{.by_u = {1, 0, 0}, .by_v = {0, 1, 0}};
    NormalVariation variation{.kind = NormalVariation::Kind::map, .texture = texture};
    const auto on_back = [&] { return perturbed_normal(variation, {}, axes, {0, 0, -1}, true); };
    CHECK(glm::distance(perturbed_normal(variation, {}, axes, {0, 0, 1}, false), leaning) < 1e-6F);
    CHECK(glm::distance(on_back(), leaning * glm::vec3(1, 1, -1)) < 1e-6F);
    variation.reversed_back = true;
    CHECK(glm::distance(on_back(), -leaning) < 1e-6F);
}

TEST_CASE("a normal that faces away from the viewer is rotated by half a turn around the surface's") {
    const glm::vec3 normal(0, 0, 1), turned(0.8F, 0, 0.6F), seen(0.6F, 0.64F, 0.48F);
    CHECK(glm::distance(facing(turned, normal, glm::normalize(glm::vec3(-3, 1, 1))),
                        glm::vec3(-0.8F, 0, 0.6F)) < 1e-6F);
    CHECK(glm::distance(facing(turned, normal, seen), turned) < 1e-6F);
}

TEST_CASE("light at a slant is dimmed where a texture turns the normal") {
    CHECK(terminator_shadowing(1, 0.01F) == 1);
    const float tilted = std::sqrt(0.5F);
    CHECK(terminator_shadowing(tilted, 1) == 1);
    CHECK(terminator_shadowing(tilted, 0.5F) == doctest::Approx(2 / (1 + std::sqrt(1 + 0.125 * 3))));
    // From a tangent of sqrt(8) on, all tilts count the same.
    CHECK(terminator_shadowing(0.1F, 0.5F) == terminator_shadowing(0.3F, 0.5F));
    CHECK(terminator_shadowing(0.3F, 0.5F) == doctest::Approx(2.0 / 3));
    CHECK(terminator_shadowing(0, 0) < 1e-5F);
}

TEST_CASE("sixteen normals are turned as each of them is, and face the viewer") {
    std::mt19937 random(3);
    std::normal_distribution<float> number;
    const auto vector = [&] { return glm::vec3(number(random), number(random), number(random)); };
    const TexturePtr texture = random_texture(random);
    using Kind = NormalVariation::Kind;
    for (const NormalVariation& variation :
         {NormalVariation{.kind = Kind::map, .texture = texture},
          NormalVariation{.kind = Kind::map, .texture = texture, .mirrored_y = true, .reversed_back = true},
          NormalVariation{.kind = Kind::bump, .texture = texture, .scale = 0.05}})
        for (const bool back : {false, true}) {
            CAPTURES(static_cast<int>(variation.kind), variation.mirrored_y, back);
            TexturePoints points{};
            LaneTextureAxes axes;
            LaneVectors towards_viewer, normals;
            for (std::size_t i = 0; i < kLanes; ++i) {
                for (Lanes& t : points.uv) t[i] = number(random);
                // One triangle has no texture axes. Another has no length along u, for which bump maps are
                // undefined.
                const bool flat = i < (variation.kind == Kind::map ? 2 : 1);
                put(axes.by_u, i, flat ? glm::vec3(0) : vector());
                put(axes.by_v, i, i < 1 ? glm::vec3(0) : vector());
                const glm::vec3 normal = glm::normalize(vector());
                put(normals, i, normal);
                const glm::vec3 towards = vector();
                put(towards_viewer, i, glm::dot(towards, normal) < 0 ? -towards : towards);
            }
            LaneVectors turned = normals;
            turn_normals(variation, points, axes, back, towards_viewer, turned);
            for (std::size_t i = 0; i < kLanes; ++i) {
                const glm::vec3 normal = vector_at(normals, i),
                                viewer = glm::normalize(vector_at(towards_viewer, i));
                const glm::vec3 one = perturbed_normal(
                    variation, {.uv = {points.uv[0][i], points.uv[1][i]}},
                    {.by_u = vector_at(axes.by_u, i), .by_v = vector_at(axes.by_v, i)}, normal, back);
                CHECK(glm::length(vector_at(turned, i) - facing(one, normal, viewer)) < 1e-5F);
                CHECK(glm::dot(vector_at(turned, i), viewer) >
                      std::min(0.0199F, glm::dot(normal, viewer) - 1e-4F));
                CHECK(glm::length(vector_at(turned, i)) == doctest::Approx(1));
            }
            CHECK(glm::length(vector_at(turned, 0) - vector_at(normals, 0)) < 1e-6F);
        }
}
