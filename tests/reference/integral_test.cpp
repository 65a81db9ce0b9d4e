// SPDX-License-Identifier: MIT
// Tests of values in closed form, and of strategies against each other.
#include "scenes.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

EnvironmentPtr noise_with_lamp() {
    EquirectImage image(32, 17, 3);
    std::mt19937 random(4);
    std::uniform_real_distribution<float> uniform;
    for (std::size_t i = 0; i < image.data.size(); i += 4) image.data[i] = uniform(random);
    for (int c = 0; c < 3; ++c) image.at(c, 5, 20)[0] = 60;
    return image_environment(image);
}

const glm::dvec3 above = glm::normalize(glm::dvec3(0.3, -0.2, 1));

}  // namespace

TEST_CASE("a diffuse surface under constant light is as bright as its albedo") {
    Scene scene;
    scene.add(square(diffuse({0.25, 0.5, 0.75})));
    scene.set_environment(constant_environment({2, 1, 1}), glm::dmat3(1.0), 3);
    const Camera camera = camera_on({0.1, 0.2, 0}, above);
    const std::vector<Stokes> cosine = point(scene, camera, 64, Strategy::surface);
    const std::vector<Stokes> both = point(scene, camera, 4096);
    const double wanted[] = {1.5, 1.5, 2.25};
    REQUIRE(cosine.size() == 3);
    for (std::size_t c = 0; c < 3; ++c) {
        // Cosine sampling is free of noise here.
        CHECK(cosine[c][0] == doctest::Approx(wanted[c]).epsilon(1e-6));
        CHECK(both[c][0] == doctest::Approx(wanted[c]).epsilon(1e-3));
        for (int p = 1; p < 4; ++p) CHECK(both[c][p] == 0);
    }
}

TEST_CASE("one channel of light or material serves all") {
    Scene scene;
    scene.add(square(diffuse({0.5})));
    scene.add(square(diffuse({0.1, 0.2, 0.3, 0.4, 0.5}), Frame(1.0), {5, 0, 0}));
    scene.set_environment(constant_environment({2}), glm::dmat3(1.0), 1);
    const std::vector<Stokes> grey = point(scene, camera_on({0, 0, 0}, above), 16, Strategy::surface);
    const std::vector<Stokes> coloured = point(scene, camera_on({5, 0, 0}, above), 16, Strategy::surface);
    REQUIRE(grey.size() == 5);
    for (std::size_t c = 0; c < 5; ++c) {
        CHECK(grey[c][0] == doctest::Approx(1).epsilon(1e-6));
        CHECK(coloured[c][0] == doctest::Approx(0.2 * (static_cast<double>(c) + 1)).epsilon(1e-6));
    }
}

TEST_CASE("sampling the light, the surface or both gives the same image") {
    for (const double alpha : {0.05, 0.4}) {
        Scene scene;
        scene.add(square(pplastic({.diffuse_reflectance = {0.3, 0.2, 0.6}, .alpha = alpha})));
        scene.set_environment(noise_with_lamp(), glm::dmat3(1.0), 1);
        const Camera camera = camera_on({0, 0, 0}, {0.8, 0.1, 0.7});
        const auto light = point(scene, camera, 1 << 18, Strategy::light, 1);
        const auto surface = point(scene, camera, 1 << 18, Strategy::surface, 2);
        const auto both = point(scene, camera, 1 << 18, Strategy::both, 3);
        for (std::size_t c = 0; c < 3; ++c) {
            CAPTURES(alpha, c);
            for (int p = 0; p < 4; ++p) {
                CHECK(std::abs(light[c][p] - both[c][p]) < 2e-3 * both[c][0]);
                CHECK(std::abs(surface[c][p] - both[c][p]) < 2e-3 * both[c][0]);
            }
            CHECK(std::abs(both[c][1]) + std::abs(both[c][2]) > 0.01 * both[c][0]);
        }
    }
}

TEST_CASE("together the strategies are less noisy than the worse of them, and more samples are better") {
    Scene scene;
    scene.add(square(pplastic({.diffuse_reflectance = {0.3}, .alpha = 0.05})));
    scene.set_environment(noise_with_lamp(), glm::dmat3(1.0), 1);
    const Camera camera = camera_on({0, 0, 0}, {0.8, 0.1, 0.7});
    const auto noise = [&](Strategy strategy, int samples) {
        double mean = 0, square = 0;
        constexpr int count = 32;
        for (std::uint64_t seed = 0; seed < count; ++seed) {
            const double value = point(scene, camera, samples, strategy, seed)[0][0];
            mean += value / count;
            square += value * value / count;
        }
        return std::sqrt(square - mean * mean) / mean;
    };
    const double both = noise(Strategy::both, 128);
    CHECK(both < 0.5 * std::fmax(noise(Strategy::light, 128), noise(Strategy::surface, 128)));
    CHECK(noise(Strategy::both, 2048) < both / 4);
}

TEST_CASE("a material seen from behind is black, and so is everything without light") {
    Scene scene;
    scene.add(square(pplastic({})));
    scene.set_environment(constant_environment({1}), glm::dmat3(1.0), 1);
    CHECK(point(scene, camera_on({0, 0, 0}, {0.2, 0.1, -1}), 64)[0] == Stokes(0.0));
    CHECK(point(scene, camera_on({0, 0, 0}, {0.2, 0.1, 1}), 64)[0][0] > 0.1);
    ReferenceStatistics statistics;
    (void)render_reference(scene, project(camera_on({0, 0, 0}, {0.2, 0.1, -1}), 1, 1), 1, 1, {.samples = 16},
                           statistics);
    CHECK(statistics.shadow_rays == 0);

    Scene dark;
    dark.add(square(diffuse({1})));
    CHECK(point(dark, camera_on({0, 0, 0}, above), 16)[0] == Stokes(0.0));
    CHECK(point(dark, camera_on({3, 0, 0}, above), 16)[0] == Stokes(0.0));
    dark.set_environment(constant_environment({0}), glm::dmat3(1.0), 1);
    CHECK(point(dark, camera_on({0, 0, 0}, above), 16)[0] == Stokes(0.0));
}

TEST_CASE("a two-sided material looks from behind as from the front of a surface rotated over") {
    const MaterialPtr material = pplastic({.alpha = 0.2});
    const Frame over(glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -1));
    Scene both_sides, front;
    both_sides.add(square(twosided(material)));
    front.add(square(material, over));
    for (Scene* scene : {&both_sides, &front}) scene->set_environment(noise_with_lamp(), glm::dmat3(1.0), 1);
    const Camera camera = camera_on({0, 0, 0}, {0.8, 0.1, -0.7});
    const auto ours = point(both_sides, camera, 1 << 14);
    const auto wanted = point(front, camera, 1 << 14);
    for (std::size_t c = 0; c < 3; ++c) {
        CHECK(wanted[c][0] > 0.1);
        for (int p = 0; p < 4; ++p) CHECK(std::abs(ours[c][p] - wanted[c][p]) < 1e-6);
    }
}

TEST_CASE("normals are interpolated over a triangle") {
    // The normals at the corners of a flat square lean outwards, and light from one direction alone follows
    // their cosine.
    Mesh mesh = make_rectangle(1);
    for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
        mesh.normals[v] = glm::normalize(glm::vec3(0.5F * mesh.positions[v].x, 0, 1));
    }
    Scene scene;
    scene.add(
        {.mesh = std::make_shared<const Mesh>(mesh), .material = diffuse({1}), .to_world = glm::dmat4(1.0)});
    // The radiance is 1 + y. Its integral with the cosine, divided by pi, is 1 + 2/3 n.y.
    EquirectImage image(8, 181, 1);
    for (int y = 0; y < 181; ++y)
        for (int x = 0; x < 8; ++x)
            image.at(0, y, x)[0] = static_cast<float>(1 + std::cos(3.14159265358979 * y / 180));
    // The rotation maps the light's y to the world's x.
    const glm::dmat3 rotation(glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0));
    scene.set_environment(image_environment(image), rotation, 1);
    for (const double x : {-0.9, -0.3, 0.0, 0.6}) {
        const glm::dvec3 normal = glm::normalize(glm::dvec3(0.5 * x, 0, 1));
        // If the shading normal leans, a sliver of its hemisphere lies below the flat square and is shadowed.
        const double value = point(scene, camera_on({x, 0.1, 0}, {0, 0, 1}), 1 << 14)[0][0];
        CHECK(std::abs(value - (1 + 2.0 / 3 * normal.x)) < 0.03);
        if (x == 0) CHECK(value == doctest::Approx(1).epsilon(2e-3));
    }
}
