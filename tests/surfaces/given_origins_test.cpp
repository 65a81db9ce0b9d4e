// SPDX-License-Identifier: MIT
#include "surfaces/given_origins.hpp"

#include "render/scenes.hpp"
#include "test.hpp"

using namespace nicol;
using test::at;
using test::coarse_sphere;

TEST_CASE("origins after a change are those of surfaces that were always so") {
    const auto cube = std::make_shared<const Mesh>(make_cube(2));
    Scene scene;
    scene.add({.mesh = coarse_sphere(8), .material = diffuse({0.5}), .to_world = at(0, 3, 0)});
    // The cubes share corners, whose origins depend on the largest coordinate of any triangle there.
    const std::uint32_t near = scene.add({.mesh = cube, .material = diffuse({0.5})});
    const std::uint32_t far = scene.add({.mesh = cube, .material = diffuse({0.5}), .to_world = at(2, 0, 0)});
    SceneGeometry surfaces;
    GivenOrigins origins;
    surfaces.update(scene);
    const std::vector<glm::vec3> first = origins.of(surfaces);
    const auto check = [&] {
        surfaces.update(scene);
        GivenOrigins fresh;
        CHECK(origins.of(surfaces) == fresh.of(surfaces));
        CHECK(origins.of(surfaces).size() == surfaces.geometry().positions.size());
    };
    scene.set_transform(far, at(2, 0, 0.5));
    check();
    const SceneGeometry::Change& change = surfaces.change();
    REQUIRE(change.kept.size() == 2);
    // A corner of the cube that stays has another origin than before.
    bool any = false;
    for (std::size_t v = change.kept[1].first; v < change.kept[1].last; ++v)
        any = any || first[v] != origins.of(surfaces)[v];
    CHECK(any);
    scene.set_transform(far, at(2, 0, 0));
    check();
    scene.remove(near);
    check();
    scene.add({.mesh = cube, .material = twosided(diffuse({0.5})), .to_world = at(0, 0, 2)});
    check();
}
