// SPDX-License-Identifier: MIT
#include "shading/shadow_rays.hpp"

#include <limits>
#include <span>

#include "test.hpp"

using namespace nicol;

TEST_CASE("a light's samples are assumed alike only after enough of them lit a point") {
    // A roof over the points, which hides the half of the sky with positive x.
    const std::vector<glm::vec3> positions{{0, 1, -9}, {0, 1, 9}, {90, 1, 9}, {90, 1, -9}};
    const std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}};
    const RaySurface roof{.positions = positions, .triangles = triangles};
    const RayScene scene(std::span(&roof, 1));
    const LaneVectors origins{};
    ShadowRays rays(scene, nullptr, origins, origins);
    const auto light_from = [](const glm::vec3& towards) {
        LaneLight out;
        for (std::size_t i = 0; i < kLanes; ++i) put(out.towards, i, towards);
        out.distance.value.fill(std::numeric_limits<float>::infinity());
        return out;
    };
    LaneLight open = light_from({-0.6F, 0.8F, 0}), hidden = light_from({0.6F, 0.8F, 0});
    constexpr std::uint32_t all = 0xFFFF;

    LightShadows shadows(&rays, 2);
    CHECK(shadows.reached(open, 0) == 0);
    CHECK(shadows.reached(open, 0) == 0);
    CHECK(shadows.reached(open, all) == all);
    CHECK(shadows.reached(hidden, all) == 0);  // the second that lights a point
    CHECK(shadows.reached(open, 0x00FF) == 0x00FF);
    CHECK(shadows.reached(hidden, all) == 0);

    LightShadows alike(&rays, 2);
    CHECK(alike.reached(open, all) == all);
    CHECK(alike.reached(open, all) == all);
    const std::uint64_t traced = rays.count();
    CHECK(alike.reached(hidden, all) == all);
    CHECK(rays.count() == traced);
    CHECK(LightShadows(nullptr, 2).reached(hidden, 0x0F0F) == 0x0F0F);
}
