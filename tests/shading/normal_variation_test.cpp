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

glm::vec3 lane(const LaneVectors& lanes, std::size_t i) {
    return {lanes.x[i], lanes.y[i], lanes.z[i]};
}
}  // namespace

TEST_CASE("sixteen normals are turned as each of them is, and face the viewer") {
    std::mt19937 random(3);
    std::normal_distribution<float> number;
    const auto vector = [&] { return glm::vec3(number(random), number(random), number(random)); };
    const TexturePtr texture = random_texture(random);
    using Kind = NormalVariation::Kind;
    for (const NormalVariation& variation :
         {NormalVariation{.kind = Kind::map, .texture = texture},
          NormalVariation{.kind = Kind::map, .texture = texture, .mirrored_y = true},
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
                const glm::vec3 normal = lane(normals, i), viewer = glm::normalize(lane(towards_viewer, i));
                const glm::vec3 one =
                    perturbed_normal(variation, {.uv = {points.uv[0][i], points.uv[1][i]}},
                                     {.by_u = lane(axes.by_u, i), .by_v = lane(axes.by_v, i)}, normal, back);
                CHECK(glm::length(lane(turned, i) - facing(one, normal, viewer)) < 1e-5F);
                CHECK(glm::dot(lane(turned, i), viewer) >
                      std::min(0.0199F, glm::dot(normal, viewer) - 1e-4F));
                CHECK(glm::length(lane(turned, i)) == doctest::Approx(1));
            }
            CHECK(glm::length(lane(turned, 0) - lane(normals, 0)) < 1e-6F);
        }
}
