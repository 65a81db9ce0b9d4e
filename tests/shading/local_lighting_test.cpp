// SPDX-License-Identifier: MIT
#include "shading/local_lighting.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "material/material.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

using Triangles = std::vector<std::array<glm::vec3, 3>>;

const Emission kWhite{.radiance = {1}};

/// A square about the z axis that faces down.
Triangles square(float side, float height) {
    const float s = side / 2;
    const glm::vec3 a(-s, -s, height), b(s, -s, height), c(s, s, height), d(-s, s, height);
    return {{a, c, b}, {a, d, c}};
}

/// Points on the floor z = 0, which face up.
struct Floor {
    explicit Floor(std::vector<glm::vec3> places, float lift = 0) : positions(std::move(places)) {
        normals.assign(positions.size(), glm::vec3(0, 0, 1));
        for (const glm::vec3& position : positions) origins.push_back(position + lift * normals[0]);
        for (std::uint32_t i = 0; i < positions.size(); ++i) seeds.push_back(i);
    }

    /// Returns s0 by point.
    std::vector<double> lit(const LocalLighting& lighting, const MaterialPtr& material, std::uint32_t seed,
                            LightingTally& tally) const {
        std::vector<std::uint32_t> own = seeds;
        for (std::uint32_t& s : own) s = 0x9E3779B9U * (s + 16 * seed + 1);
        std::vector<glm::vec4> stokes(positions.size(), glm::vec4(0));
        const std::span<glm::vec4> channel(stokes);
        const Material* const layer = material.get();
        tally += lighting.add(Viewpoint{.eye = {0, -3, 2}},
                              {.positions = positions,
                               .normals = normals,
                               .tangents = {},
                               .facets = {},
                               .unperturbed = {},
                               .origins = origins,
                               .mirrored = nullptr,
                               .parts = {},
                               .seeds = own,
                               .shadowed = true},
                              {.layers = {&layer, 1}, .weights = {}}, {&channel, 1});
        std::vector<double> out;
        for (const glm::vec4& s : stokes) out.push_back(s.x);
        return out;
    }

    std::vector<glm::vec3> positions, normals, origins;
    std::vector<std::uint32_t> seeds;
};

LocalLighting::Lights lights(const Triangles& triangles) {
    LocalLighting::Lights out;
    out.local.push_back(light_source({.emission = kWhite, .axis = {1, 0, 0}, .triangles = triangles}));
    return out;
}

/// Rays against triangles.
struct Blockers {
    explicit Blockers(const Triangles& triangles) {
        for (const auto& corners : triangles) {
            const auto first = static_cast<std::uint32_t>(positions.size());
            positions.insert(positions.end(), corners.begin(), corners.end());
            indices.emplace_back(first, first + 1, first + 2);
        }
        const RaySurface surface{.positions = positions, .triangles = indices};
        scene.emplace(std::span(&surface, 1));
    }

    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> indices;
    std::optional<RayScene> scene;
};

}  // namespace

TEST_CASE("A light casts no shadow of itself, however close and slanted it is") {
    const MaterialPtr material = diffuse({0.5});
    for (const float height : {0.02F, 0.1F, 1.0F}) {
        CAPTURE(height);
        const Triangles light = square(1, height);
        const Blockers blockers(light);
        std::vector<glm::vec3> places;
        for (int i = 0; i < 16; ++i) places.emplace_back(0.07F * static_cast<float>(i) - 0.4F, 0.1F, 0);
        const Floor floor(places, static_cast<float>(5 * kRayOffset));
        LightingTally tally;
        const std::vector<double> alone =
            floor.lit(LocalLighting(lights(light), nullptr, 64), material, 0, tally);
        CHECK(tally.rays == 0);
        const std::vector<double> shadowed =
            floor.lit(LocalLighting(lights(light), &*blockers.scene, 64), material, 0, tally);
        CHECK(tally.rays > 0);
        for (std::size_t i = 0; i < alone.size(); ++i) {
            CAPTURE(i);
            CHECK(alone[i] > 0);
            CHECK(shadowed[i] == alone[i]);
        }
    }
}

TEST_CASE("A light does not light itself, whatever its slant") {
    for (const bool two_sided : {false, true}) {
        CAPTURE(two_sided);
        const glm::vec3 corner(-0.7F, 1.3F, 4.1F), first(1.9F, 0.4F, -0.3F), second(-0.2F, 1.1F, 1.7F);
        const glm::vec3 b = corner + first, d = corner + second, c = b + second;
        const Triangles triangles{std::array{corner, b, c}, std::array{corner, c, d}};
        LocalLighting::Lights own;
        own.local.push_back(light_source({.emission = {.radiance = {1}, .two_sided = two_sided},
                                          .axis = {1, 0, 0},
                                          .triangles = triangles}));
        std::vector<glm::vec3> places;
        for (int i = 0; i < 16; ++i)
            places.push_back(corner + 0.061F * static_cast<float>(i + 1) * first + 0.37F * second);
        Floor floor(places);
        floor.normals.assign(places.size(), glm::normalize(glm::cross(first, second)));
        const LocalLighting lighting(std::move(own), nullptr, 64);
        LightingTally tally;
        for (const double s0 : floor.lit(lighting, diffuse({0.5}), 0, tally)) CHECK(s0 == 0);
    }
}

TEST_CASE("The tally's noise is that of other seeds") {
    struct Case {
        const char* name;
        MaterialPtr material;
        Triangles light;
        bool shadowed;
    };
    const MaterialPtr matt = diffuse({0.5});
    const MaterialPtr glossy = pplastic({.alpha = 0.2});
    const Case cases[] = {{"matt, wide", matt, square(2, 1), false},
                          {"glossy, wide", glossy, square(2, 1), false},
                          {"glossy, very wide", glossy, square(6, 1), false},
                          {"matt, in a penumbra", matt, square(1, 2), true}};
    for (const Case& of : cases) {
        CAPTURE(of.name);
        std::vector<glm::vec3> places;
        for (int i = 0; i < 16; ++i) places.emplace_back(0.1F * static_cast<float>(i), 0.05F, 0);
        const Floor floor(places);
        const Blockers blocker(square(0.6F, 1));
        const LocalLighting lighting(lights(of.light), of.shadowed ? &*blocker.scene : nullptr, 16);
        constexpr std::uint32_t count = 400;
        LightingTally tally;
        std::vector<double> sums(places.size()), squares(places.size());
        double power = 0;
        for (std::uint32_t seed = 0; seed < count; ++seed) {
            const std::vector<double> found = floor.lit(lighting, of.material, seed, tally);
            for (std::size_t i = 0; i < found.size(); ++i) {
                sums[i] += found[i];
                squares[i] += found[i] * found[i];
                power += found[i] * found[i];
            }
        }
        double variance = 0;
        for (std::size_t i = 0; i < sums.size(); ++i) variance += squares[i] - sums[i] * sums[i] / count;
        CHECK(tally.values == count * places.size());
        CHECK(tally.power == doctest::Approx(power));
        const double ratio = tally.noise / variance;
        INFO("noise " << std::sqrt(variance / power) << " of s0, predicted over it " << std::sqrt(ratio));
        CHECK(ratio > 0.5);
        CHECK(ratio < 2);
    }
}

TEST_CASE("Where the shadow of a small light ends, points get as many samples as of a very wide light") {
    // The shadow's soft edge is 0.1 wide.
    const Triangles light = square(0.1F, 2);
    const Blockers blocker(square(1, 1));
    struct Found {
        double rays, variance;
    };
    const auto found = [&](float from, int samples) {
        std::vector<glm::vec3> places;
        for (int i = 0; i < 16; ++i) places.emplace_back(from + 0.006F * static_cast<float>(i), 0.01F, 0);
        const Floor floor(places);
        const LocalLighting lighting(lights(light), &*blocker.scene, samples);
        constexpr std::uint32_t count = 200;
        LightingTally tally;
        double variance = 0;
        std::vector<double> sums(places.size()), squares(places.size());
        for (std::uint32_t seed = 0; seed < count; ++seed) {
            const std::vector<double> lit = floor.lit(lighting, diffuse({0.5}), seed, tally);
            for (std::size_t i = 0; i < lit.size(); ++i) {
                sums[i] += lit[i];
                squares[i] += lit[i] * lit[i];
            }
        }
        for (std::size_t i = 0; i < sums.size(); ++i) variance += squares[i] - sums[i] * sums[i] / count;
        return Found{static_cast<double>(tally.rays) / (count * 16.0), variance};
    };
    CHECK(found(1.5F, 16).rays == 4);
    CHECK(found(0.95F, 16).rays == 32);
    CHECK(found(0.95F, 16).variance < 0.4 * found(0.95F, 4).variance);
}

TEST_CASE("Dim lights cast no shadow rays where they add next to nothing to what is there") {
    const Blockers blocker(square(0.6F, 1));
    std::vector<glm::vec3> places;
    for (int i = 0; i < 16; ++i) places.emplace_back(0.15F * static_cast<float>(i), 0.05F, 0);
    const Floor floor(places);
    // The sun's shadow lies left, and that of the dim lights lies in the sunlight.
    const auto lights_of = [](bool sun, double dim) {
        LocalLighting::Lights out;
        const auto add = [&](double value, const glm::dvec3& place) {
            LocalLight light{.kind = LocalLight::Kind::point, .value = {value}};
            light.to_world[3] = glm::dvec4(place, 1);
            out.local.push_back(light_source(light, glm::dmat4(1.0)));
        };
        for (int i = 0; i < 8; ++i) add(dim, {-1 - 0.05 * i, 0, 2});
        if (sun) add(10, {0, 0, 4});
        return out;
    };
    struct Case {
        const char* name;
        bool sun;
        double dim;
        bool spared;
    };
    constexpr double negligible = 3e-4;
    const Case cases[] = {{"far below the sun", true, 1e-5, true},
                          {"together above the share", true, 5e-4, true},
                          {"no sun", false, 1e-5, false},
                          {"not dim", true, 1, false}};
    for (const MaterialPtr& material : {diffuse({0.5}), pplastic({.alpha = 0.2})}) {
        for (const Case& of : cases) {
            CAPTURE(of.name);
            LightingTally all, fewer;
            const std::vector<double> truth =
                floor.lit(LocalLighting(lights_of(of.sun, of.dim), &*blocker.scene, 16), material, 0, all);
            const std::vector<double> found =
                floor.lit(LocalLighting(lights_of(of.sun, of.dim), &*blocker.scene, 16, negligible), material,
                          0, fewer);
            CHECK(all.rays_spared == 0);
            CHECK(fewer.rays_spared + fewer.rays == all.rays);
            CHECK((fewer.rays_spared > 0) == of.spared);
            for (std::size_t i = 0; i < truth.size(); ++i) {
                CAPTURE(i);
                CHECK(found[i] >= truth[i] * (1 - 1e-6));
                CHECK(found[i] <= truth[i] * (1 + negligible + 1e-6));
            }
            // In the sun's shadow the dim lights are all there is.
            if (of.spared) CHECK(found[0] < 0.01 * found[10]);
        }
    }
}
