// SPDX-License-Identifier: MIT
#include "shading/shadow_rays.hpp"

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <span>

#include "shading/light_samples.hpp"
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

    LightShadows shadows(&rays, nullptr, 2);
    CHECK(shadows.reached(open, 0) == 0);
    CHECK(shadows.reached(open, 0) == 0);
    CHECK(shadows.reached(open, all) == all);
    CHECK(shadows.reached(hidden, all) == 0);  // the second that lights a point
    CHECK(shadows.reached(open, 0x00FF) == 0x00FF);
    CHECK(shadows.reached(hidden, all) == 0);

    LightShadows alike(&rays, nullptr, 2);
    CHECK(alike.reached(open, all) == all);
    CHECK(alike.reached(open, all) == all);
    const std::uint64_t traced = rays.count();
    CHECK(alike.reached(hidden, all) == all);
    CHECK(rays.count() == traced);
    CHECK(LightShadows(nullptr, nullptr, 2).reached(hidden, 0x0F0F) == 0x0F0F);
}

TEST_CASE("the edge of a shadow hides the fraction of a pixel's light that lies behind it") {
    // A roof over the floor y = 0, which hides what has a positive x (or a negative z) from light above.
    const glm::vec3 down = glm::vec3(0, -1, 0);
    for (const bool across : {false, true}) {
        const std::vector<glm::vec3> positions =
            across ? std::vector<glm::vec3>{{-9, 1, 0}, {9, 1, 0}, {9, 1, -9}, {-9, 1, -9}}
                   : std::vector<glm::vec3>{{0, 1, -9}, {0, 1, 9}, {9, 1, 9}, {9, 1, -9}};
        const std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}};
        const RaySurface roof{.positions = positions, .triangles = triangles};
        const RayScene scene(std::span(&roof, 1));

        const std::vector<glm::vec3> floor{{-90, 0, -90}, {90, 0, -90}, {0, 0, 90}};
        const std::vector<glm::vec3> normals(3, -down);
        Viewpoint view{.orthographic = true, .eye = {0, 2, 0}};
        view.forward = glm::dvec3(down);
        view.right = {1, 0, 0};
        view.up = {0, 0, -1};
        constexpr float side = 0.5F;
        std::vector<PixelOrigins::Part> parts;
        std::vector<float> expected;
        LaneVectors points;
        LaneLight light;
        for (std::uint32_t i = 0; i < kLanes; ++i) {
            // A row of pixels that the edge passes through, or that lies along the edge.
            const glm::vec2 middle(static_cast<float>(i) * 0.1F - 0.8F, 0.1F);
            parts.push_back({.triangle = {0, 1, 2},
                             .middle = middle,
                             .size = glm::vec2(side),
                             .lift = -1e-4F * down,
                             .pixel = i});
            put(points, i, {middle.x, 0, -middle.y});
            put(light.towards, i, -down);
            const float away = across ? middle.y : middle.x;
            expected.push_back(glm::clamp(0.5F - away / side, 0.0F, 1.0F));
        }
        light.distance.value.fill(std::numeric_limits<float>::infinity());
        light.irradiance.resize(1);
        light.irradiance[0][0].value.fill(1);
        PixelOrigins places(view, floor, normals, parts);
        ShadowRays rays(scene, nullptr, points, points);
        LightShadows shadows(&rays, &places, 4);
        const std::uint32_t lit = shadows.reached_in_part(light, 0xFFFF);
        const Lanes& fractions = light.irradiance[0][0];
        for (std::size_t i = 0; i < kLanes; ++i) {
            CAPTURES(across, i);
            CHECK(fractions[i] == doctest::Approx(expected[i]).epsilon(0.07));
            CHECK((lit >> i & 1U) == (fractions[i] > 0 ? 1U : 0U));
            // A part of the variance of as many random places, over the square of the fraction.
            const float random =
                fractions[i] > 0 ? (1 - fractions[i]) / fractions[i] / PixelOrigins::kEven : 0;
            CHECK(shadows.doubts()[i] <= random);
            CHECK(shadows.doubts()[i] >= 0.2F * random);
        }
        CHECK(rays.count() == PixelOrigins::kEven * kLanes);
    }
}

TEST_CASE("places in pixels and parts of a wide light are sampled independently") {
    // A roof over the floor y = 0, which hides what has a positive x from light above.
    const std::vector<glm::vec3> positions{{0, 1, -9}, {0, 1, 9}, {9, 1, 9}, {9, 1, -9}};
    const std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}};
    const RaySurface roof{.positions = positions, .triangles = triangles};
    const RayScene scene(std::span(&roof, 1));
    const std::vector<glm::vec3> floor{{-90, 0, -90}, {90, 0, -90}, {0, 0, 90}}, normals(3, {0, 1, 0});
    const Viewpoint view{
        .orthographic = true, .eye = {0, 2, 0}, .forward = {0, -1, 0}, .up = {0, 0, -1}, .right = {1, 0, 0}};
    constexpr float side = 0.5F;  // of pixels, and of the light as the roof's edge projects it
    constexpr std::uint32_t samples = 32, rows = 20, lanes = kLanes;
    double sum = 0;
    for (std::uint32_t row = 0; row < rows; ++row) {
        std::vector<PixelOrigins::Part> parts;
        std::array<std::uint32_t, kLanes> seeds;
        std::array<float, kLanes> lit{};
        LaneVectors points;
        for (std::uint32_t i = 0; i < kLanes; ++i) {
            const glm::vec2 middle(static_cast<float>(i) * 0.06F - 0.45F, 0.1F);
            parts.push_back({.triangle = {0, 1, 2},
                             .middle = middle,
                             .size = glm::vec2(side),
                             .lift = {0, 1e-4F, 0},
                             .pixel = lanes * row + i});
            put(points, i, {middle.x, 0, -middle.y});
            seeds[i] = sample_seed(lanes * row + i, 0);
        }
        PixelOrigins places(view, floor, normals, parts);
        ShadowRays rays(scene, nullptr, points, points);
        LightShadows shadows(&rays, &places, samples);
        for (std::uint32_t k = 0; k < samples; ++k) {
            Lanes u, v;
            light_samples(k, seeds, u, v);
            LaneLight light;
            for (std::size_t i = 0; i < kLanes; ++i)
                put(light.towards, i, glm::normalize(glm::vec3(side * (u[i] - 0.5F), 1, 0)));
            light.distance.value.fill(std::numeric_limits<float>::infinity());
            const std::uint32_t some = shadows.reached(light, 0xFFFF);
            for (std::size_t i = 0; i < kLanes; ++i) lit[i] += static_cast<float>(some >> i & 1U) / samples;
        }
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float away = std::abs(parts[i].middle.x) / side;
            const float beyond = 0.5F * (1 - away) * (1 - away);
            const float off = lit[i] - (parts[i].middle.x < 0 ? 1 - beyond : beyond);
            sum += static_cast<double>(off * off);
        }
    }
    CHECK(std::sqrt(sum / (kLanes * rows)) <= 0.045);
}
