// SPDX-License-Identifier: MIT
#include "scene/scene.hpp"

#include "render/scenes.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

std::shared_ptr<const Mesh> cube() {
    return std::make_shared<const Mesh>(make_cube(1));
}

WorldGeometry world_geometry(const Scene& scene) {
    SceneGeometry surfaces;
    surfaces.update(scene);
    return surfaces.geometry();
}

Projection from_z(double distance) {
    return project(test::camera_at({0, 0, distance}), 64, 64);
}

}  // namespace

TEST_CASE("every change counts, and nothing else does") {
    Scene scene;
    const auto id = scene.add({.mesh = cube(), .material = diffuse({0.5})});
    const auto geometry = scene.geometry_version();
    const auto light = scene.light_version();
    scene.set_transform(id, glm::dmat4(1.0));
    CHECK(scene.geometry_version() == geometry);
    scene.set_transform(id, test::at(0, 0, 0, 2));
    CHECK(scene.geometry_version() > geometry);
    CHECK(scene.light_version() == light);
    scene.set_environment(constant_environment({1}), glm::dmat3(1.0), 1);
    CHECK(scene.light_version() > light);
}

TEST_CASE("what does not fit is refused and changes nothing") {
    Scene scene;
    const EnvironmentPtr light = constant_environment({1});
    const MaterialPtr grey = diffuse({0.5});
    for (const Instance& bad : {Instance{.mesh = nullptr, .material = grey},
                                {.mesh = cube(), .material = nullptr},
                                {.mesh = cube(), .material = grey, .to_world = glm::dmat4(0.0)}})
        CHECK_THROWS_AS(scene.add(bad), Error);
    CHECK(scene.instances().empty());
    scene.add({.mesh = cube(), .material = diffuse({0.5, 0.4, 0.3})});
    CHECK(scene.channels() == 3);
    CHECK_THROWS_AS(scene.add({.mesh = cube(), .material = diffuse({0.5, 0.4})}), Error);
    CHECK_THROWS_AS(scene.set_environment(constant_environment({1, 2}), glm::dmat3(1.0), 1), Error);
    for (const auto& [rotation, scale] : {std::pair(1.0, -1.0), {2.0, 1.0}, {-1.0, 1.0}})
        CHECK_THROWS_AS(scene.set_environment(light, glm::dmat3(rotation), scale), Error);
    CHECK(scene.environment() == nullptr);
    CHECK_THROWS_AS(scene.set_transform(1, glm::dmat4(1.0)), Error);
}

TEST_CASE("instances become one list of triangles in the world") {
    Scene scene;
    const auto mesh = cube();
    scene.add({.mesh = mesh, .material = diffuse({0.5})});
    scene.add({.mesh = mesh, .material = diffuse({0.1}), .to_world = test::at(10, 0, 0)});
    const WorldGeometry world = world_geometry(scene);
    CHECK(world.positions.size() == 2 * mesh->positions.size());
    CHECK(world.triangles.size() == 2 * mesh->triangles.size());
    REQUIRE(world.ranges.size() == 2);
    CHECK(world.ranges[1].first == mesh->positions.size());
    CHECK(world.ranges[1].material == scene.instances()[1].material);
    CHECK(world.positions[world.ranges[1].first] == mesh->positions[0] + glm::vec3(10, 0, 0));
    for (std::size_t t = mesh->triangles.size(); t < world.triangles.size(); ++t) {
        CHECK(std::min({world.triangles[t].x, world.triangles[t].y, world.triangles[t].z}) >=
              world.ranges[1].first);
    }
}

TEST_CASE("of a cube in front of the camera only the near face can be visible") {
    Scene scene;
    scene.add({.mesh = cube(), .material = diffuse({0.5})});
    const WorldGeometry world = world_geometry(scene);
    std::vector<std::uint8_t> visible;
    const std::size_t skipped = find_visible(world, from_z(5), visible);
    CHECK(skipped == world.positions.size() - 4);
    for (std::size_t v = 0; v < visible.size(); ++v) {
        CHECK((visible[v] != 0) == (world.normals[v].z > 0.5F));
    }
    // Every face shows its back from inside.
    CHECK(find_visible(world, from_z(0.5), visible) == world.positions.size());
}

TEST_CASE("triangles outside one side of the view are skipped, those that straddle it are kept") {
    std::vector<std::uint8_t> visible;
    const auto skipped = [&](const glm::dmat4& place, double camera) {
        Scene scene;
        scene.add({.mesh = test::rectangle(1), .material = diffuse({0.5}), .to_world = place});
        return find_visible(world_geometry(scene), from_z(camera), visible);
    };
    CHECK(skipped(test::at(100, 0, 0), 5) == 4);
    // The square exceeds the image on every side: no vertex is in view, but its middle is.
    CHECK(skipped(test::at(0, 0, 0, 100), 5) == 0);
    CHECK(skipped(test::at(0, 0, 0, 100), -5) == 4);  // behind the camera
}

TEST_CASE("instances are removed and their materials swapped by ids that are not given again") {
    Scene scene;
    const auto first = scene.add({.mesh = cube(), .material = diffuse({0.5})});
    const auto second = scene.add({.mesh = cube(), .material = diffuse({0.1, 0.2, 0.3})});
    const auto materials = scene.material_version();
    const auto geometry = scene.geometry_version();
    CHECK_THROWS_AS(scene.set_material(first, diffuse({0.1, 0.2})), Error);
    CHECK_THROWS_AS(scene.set_material(first, nullptr), Error);
    CHECK_THROWS_AS(scene.set_material(7, diffuse({0.1})), Error);
    CHECK(scene.material_version() == materials);
    // The only instance with three channels may change its number of channels.
    const MaterialPtr two = diffuse({0.1, 0.2});
    scene.set_material(second, two);
    CHECK(scene.at(second).material == two);
    CHECK(scene.channels() == 2);
    CHECK(scene.material_version() > materials);
    CHECK(scene.geometry_version() == geometry);

    scene.remove(first);
    CHECK(scene.geometry_version() > geometry);
    CHECK(scene.ids() == std::vector{second});
    CHECK_THROWS_AS(scene.remove(first), Error);
    CHECK_THROWS_AS(scene.set_transform(first, glm::dmat4(1.0)), Error);
    CHECK_THROWS_AS(scene.at(first), Error);
    scene.remove(second);
    CHECK(scene.instances().empty());
    CHECK(scene.add({.mesh = cube(), .material = diffuse({0.5})}) == second + 1);
}
