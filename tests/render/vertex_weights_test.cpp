// SPDX-License-Identifier: MIT
#include "render/vertex_weights.hpp"

#include <set>

#include "render/scenes.hpp"
#include "surfaces/scene_geometry.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("half of the weight of vertices goes by area, half is equal, and samples are drawn by weight") {
    const MaterialPtr wall = diffuse({0.5}), ball = diffuse({0.6});
    Scene scene;
    scene.add({.mesh = test::coarse_sphere(8), .material = ball});
    scene.add({.mesh = test::rectangle(1), .material = wall, .to_world = test::at(0, 0, -5, 50)});
    SceneGeometry surfaces;
    surfaces.update(scene);
    const WorldGeometry& geometry = surfaces.geometry();
    const double vertices = static_cast<double>(geometry.positions.size());
    const double of_ball = vertices - 4;

    const VertexWeights weights(geometry);
    REQUIRE(weights.groups().size() == 2);
    const VertexWeights::Group& few = weights.groups().at(wall);
    const VertexWeights::Group& many = weights.groups().at(ball);
    CHECK(few.weight + many.weight == doctest::Approx(vertices));
    // The wall has nearly all of the area, 10,000 of 10,012.
    CHECK(few.weight == doctest::Approx(0.5 * 4 + 0.5 * vertices * 10000 / (10000 + 4 * 3.14)).epsilon(1e-3));
    CHECK(many.weight > 0.5 * of_ball);

    for (const auto& [material, group] : weights.groups()) {
        CHECK(std::abs(static_cast<double>(group.sample.size()) - 512 * group.weight / vertices) <= 1);
        for (const std::uint32_t v : group.sample)
            CHECK(geometry.ranges[range_of(geometry, v)].material == material);
    }
    CHECK(std::set(few.sample.begin(), few.sample.end()).size() == 4);
    // A sample of vertices that weigh the same steps over them evenly.
    for (std::size_t k = 1; k < many.sample.size(); ++k) {
        const double step = many.sample[k] - many.sample[k - 1];
        CHECK(std::abs(step - of_ball / static_cast<double>(many.sample.size())) < 2);
    }
}
