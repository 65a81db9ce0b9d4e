// SPDX-License-Identifier: MIT
// Tests of changes of light at sixteen points.
#include "shading/light_changes.hpp"

#include <glm/geometric.hpp>

#include "shading/light_samples.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("scattered directions have the variance of their blobs and stay above the horizon") {
    constexpr float variance = 0.01F;
    constexpr std::uint32_t samples = 256;
    const std::vector<std::uint32_t> seeds(kLanes, 7);
    Lanes variances;
    variances.value.fill(variance);
    for (const bool grazing : {false, true}) {
        const glm::vec3 normal = grazing ? glm::normalize(glm::vec3(1, 0, 0.02F)) : glm::vec3(0, 0, 1);
        const std::vector<glm::vec3> normals(kLanes, normal);
        glm::dvec3 mean(0), square(0);
        for (std::uint32_t k = 0; k < samples; ++k) {
            LaneLight light;
            for (std::size_t i = 0; i < kLanes; ++i) put(light.towards, i, {0, 0, 1});
            Lanes u, v;
            light_samples(k, seeds, u, v);
            scatter(normals, variances, u, v, light);
            const glm::dvec3 place(vector_at(light.towards, k % kLanes));
            CHECK(glm::length(place) == doctest::Approx(1));
            CHECK(glm::dot(place, glm::dvec3(normal)) > 0);
            mean += place / double{samples};
            square += place * place / double{samples};
        }
        if (grazing) continue;
        CHECK(std::abs(mean.x) < 0.01);
        CHECK(std::abs(mean.y) < 0.01);
        CHECK(std::abs(square.x / double{variance} - 1) < 0.05);
        CHECK(std::abs(square.y / double{variance} - 1) < 0.05);
    }
}

TEST_CASE("hidden points lose their light, and others keep it") {
    LaneLight light;
    light.components = 3;
    light.irradiance.resize(2);
    for (std::array<Lanes, 4>& channel : light.irradiance)
        for (Lanes& component : channel) component.value.fill(2);
    hide(0x0005, light);
    for (const std::array<Lanes, 4>& channel : light.irradiance)
        for (std::size_t p = 0; p < light.components; ++p)
            for (std::size_t i = 0; i < kLanes; ++i) CHECK(channel[p][i] == (i == 0 || i == 2 ? 0.0F : 2.0F));
}
