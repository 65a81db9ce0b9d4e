// SPDX-License-Identifier: MIT
#include "surfaces/scene_geometry.hpp"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <span>

#include "geometry/block_numbers.hpp"
#include "geometry/deformed_mesh.hpp"
#include "geometry/graded_mesh.hpp"
#include "render/scenes.hpp"
#include "test.hpp"

using namespace nicol;
using test::at;
using test::coarse_sphere;

namespace {

Scene two_balls() {
    Scene scene;
    scene.add({.mesh = coarse_sphere(4), .material = diffuse({0.5})});
    scene.add({.mesh = coarse_sphere(2), .material = diffuse({0.4}), .to_world = at(3, 0, 0)});
    return scene;
}

bool inside(const Ball& ball, const glm::vec3& point) {
    return glm::distance(ball.centre, point) <= ball.radius;
}

// Checks that all triangles have the corners of the instances' meshes in place, in the order of these.
// divided: index of the instance whose triangles are divided; none: the number of instances.
void check_corners(const SceneGeometry& surfaces, const Scene& scene, std::size_t divided) {
    const WorldGeometry& geometry = surfaces.geometry();
    std::vector<Mesh> meshes;
    std::vector<MeshExtent> extents;
    for (std::size_t i = 0; i < scene.instances().size(); ++i) {
        const Instance& instance = scene.instances()[i];
        meshes.push_back(placed(*instance.mesh, glm::inverse(surfaces.to_world()) * instance.to_world, 0));
        extents.push_back(extent_of(meshes.back()));
    }
    const Details details(extents);
    REQUIRE(surfaces.blockers().size() == meshes.size());
    std::size_t triangles = 0, elsewhere = 0;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        CAPTURE(i);
        const auto parts = graded(meshes[i], details.beside(extents[i]));
        CHECK((parts != nullptr) == (i == divided));
        const Mesh& mesh = parts ? *parts : meshes[i];
        const SceneGeometry::Blocker& blocker = surfaces.blockers()[i];
        REQUIRE(blocker.triangles == mesh.triangles.size());
        REQUIRE(blocker.last - blocker.first == mesh.positions.size());
        const std::size_t sides = blocker.two_sided ? 2 : 1;
        triangles += sides * blocker.triangles;
        float farthest = 0, bent = 0;
        for (std::size_t side = 0; side < sides; ++side)
            for (std::size_t t = 0; t < blocker.triangles; ++t) {
                const glm::uvec3& corners =
                    geometry.triangles[blocker.first_triangle + side * blocker.triangles + t];
                glm::uvec3 expected = mesh.triangles[t];
                if (side == 1) std::swap(expected.y, expected.z);
                for (int k = 0; k < 3; ++k) {
                    const std::size_t v = corners[k], of_mesh = expected[k];
                    elsewhere += v - blocker.first != of_mesh ? 1 : 0;
                    farthest =
                        std::max(farthest, glm::distance(geometry.positions[v], mesh.positions[of_mesh]) /
                                               static_cast<float>(extents[i].ball.radius));
                    const glm::vec3 normal = (side == 0 ? 1.0F : -1.0F) * mesh.normals[of_mesh];
                    bent = std::max(bent, glm::distance(geometry.normals[v], normal));
                }
            }
        CHECK(farthest < 1e-6);
        CHECK(bent < 1e-5);
    }
    CHECK(triangles == geometry.triangles.size());
    CHECK(elsewhere > triangles);  // The order is another one than the meshes'.
}

}  // namespace

TEST_CASE("triangles have the corners of their meshes, in whatever order the vertices are") {
    const auto ball = test::fine_sphere();
    const auto floor = std::make_shared<const Mesh>(make_rectangle(40));
    REQUIRE(floor->positions.size() >= kLeastOrdered);
    Scene scene;
    scene.add({.mesh = ball, .material = diffuse({0.5})});
    scene.add({.mesh = ball, .material = diffuse({0.4}), .to_world = at(3, 0, 0)});
    scene.add({.mesh = ball,
               .material = diffuse({0.4}),
               .to_world = glm::scale(at(0, 3, 0), glm::dvec3(-1, 2, 1))});
    scene.add({.mesh = ball, .material = twosided(diffuse({0.4})), .to_world = at(0, 6, 0)});
    const glm::dmat4 wide = glm::scale(at(0, 0, -3), glm::dvec3(2000, 2000, 1));
    const std::uint32_t below = scene.add({.mesh = floor, .material = diffuse({0.4}), .to_world = wide});
    scene.add({.mesh = ball,
               .material = twosided(diffuse({0.4})),
               .to_world = glm::scale(at(0, 9, 0), glm::dvec3(1, 1, -1))});
    SceneGeometry surfaces;
    surfaces.update(scene);
    check_corners(surfaces, scene, 6);
    const std::uint32_t small = scene.add({.mesh = coarse_sphere(2),
                                           .material = diffuse({0.4}),
                                           .to_world = glm::scale(at(30, 40, -3), glm::dvec3(0.01))});
    surfaces.update(scene);
    check_corners(surfaces, scene, below);
    scene.set_transform(small, at(1, 0, 0) * scene.at(small).to_world);
    surfaces.update(scene);
    check_corners(surfaces, scene, below);
    scene.remove(small);
    surfaces.update(scene);
    check_corners(surfaces, scene, 6);
    scene.set_transform(1, glm::rotate(at(3, 0, 1), 0.5, glm::dvec3(1, 1, 0)));
    surfaces.update(scene);
    check_corners(surfaces, scene, 6);
}

TEST_CASE("a deformed mesh keeps its vertices' order, which no other instance takes over") {
    Scene scene;
    const auto ball = test::fine_sphere();
    scene.add({.mesh = ball, .material = diffuse({0.5})});
    SceneGeometry surfaces;
    surfaces.update(scene);
    const std::vector<glm::uvec3> given = surfaces.geometry().triangles;
    std::vector<glm::vec3> positions = ball->positions;
    for (glm::vec3& p : positions) p = glm::vec3(3, 1, 0.2F) * p;
    const auto flat = std::make_shared<const Mesh>(deformed(*ball, std::move(positions), {}));
    scene.set_mesh(0, flat);
    surfaces.update(scene);
    CHECK(surfaces.geometry().triangles == given);
    // The deformed instance also moves, and is still no source of orders.
    scene.set_transform(0, glm::rotate(at(0, 0, 5), 0.5, glm::dvec3(1, 1, 0)));
    surfaces.update(scene);
    scene.add({.mesh = flat, .material = diffuse({0.5})});
    surfaces.update(scene);
    SceneGeometry fresh;
    fresh.update(scene);
    const std::span<const glm::uvec3> now(surfaces.geometry().triangles),
        expected(fresh.geometry().triangles);
    const std::size_t half = given.size();
    REQUIRE(now.size() == 2 * half);
    CHECK(std::ranges::equal(now.first(half), given));
    CHECK(std::ranges::equal(now.subspan(half), expected.subspan(half)));
    CHECK_FALSE(std::ranges::equal(now.first(half), expected.first(half)));
}

TEST_CASE("an instance that is moved too far is named") {
    Scene scene = two_balls();
    scene.remove(0);
    scene.set_transform(1, at(1e15, 0, 0));
    SceneGeometry surfaces;
    CHECK_NOTHROW(surfaces.update(scene));
    const std::uint32_t id =
        scene.add({.mesh = coarse_sphere(3), .material = diffuse({0.4}), .to_world = at(0, -2e15, 0)});
    const std::string message = error_of(CALL(surfaces.update(scene)));
    CHECK(message.starts_with("instance " + std::to_string(id) + ": "));
    CHECK(message.find("beyond 1e15") != std::string::npos);
}

TEST_CASE("positions far from the world's origin are as accurate as positions near it") {
    SceneGeometry near_origin, far_away;
    Scene scene = two_balls();
    near_origin.update(scene);
    CHECK(near_origin.to_world() == glm::dmat4(1));
    for (const glm::dvec3& shift : {glm::dvec3(1e6, -2e5, 7), glm::dvec3(0, 1e12, 0)}) {
        Scene moved = two_balls();
        const glm::dmat4 motion = at(shift.x, shift.y, shift.z);
        for (const auto id : moved.ids()) moved.set_transform(id, motion * moved.at(id).to_world);
        far_away = SceneGeometry();
        far_away.update(moved);
        const Version version = far_away.version();
        const glm::dvec3 origin(far_away.to_world()[3]);
        for (std::size_t v = 0; v < near_origin.geometry().positions.size(); ++v) {
            const glm::dvec3 expected = glm::dvec3(near_origin.geometry().positions[v]) + (shift - origin);
            CHECK(glm::distance(glm::dvec3(far_away.geometry().positions[v]), expected) < 2e-6);
        }
        // A small motion far away is a motion.
        const std::uint32_t small = moved.ids()[1];
        moved.set_transform(small, at(0, 1e-3, 0) * moved.at(small).to_world);
        far_away.update(moved);
        CHECK(far_away.version() != version);
    }
}

TEST_CASE("the largest instance carries the axes") {
    Scene scene = two_balls();
    SceneGeometry surfaces;
    surfaces.update(scene);
    const Version first = surfaces.version();
    const glm::dmat4 motion = glm::rotate(at(1, 2, 3), 0.5, glm::dvec3(1, 1, 0));
    const glm::dmat3 axes = surfaces.own_axes();
    for (const auto id : scene.ids()) scene.set_transform(id, motion * scene.at(id).to_world);
    surfaces.update(scene);
    CHECK(surfaces.version() == first);
    CHECK(surfaces.own_axes() == axes);
    for (int i = 0; i < 4; ++i) CHECK(glm::distance(surfaces.to_world()[i], motion[i]) < 1e-12);

    // A fresh start finds the same axes, rotated.
    SceneGeometry fresh;
    fresh.update(scene);
    CHECK(fresh.to_world() == glm::dmat4(1));
    for (int i = 0; i < 3; ++i)
        CHECK(glm::distance(fresh.own_axes()[i], glm::dmat3(motion) * axes[i]) < 1e-12);

    // Scaling changes the shape of the largest instance, while the other one stays.
    scene.set_transform(0, glm::scale(motion, glm::dvec3(1.1)));
    surfaces.update(scene);
    CHECK(surfaces.version() > first);
    CHECK(surfaces.to_world() == glm::dmat4(1));
}

TEST_CASE("the axes stay with most vertices if the largest instance moves alone") {
    Scene scene = two_balls();
    for (const double x : {4.0, 6.0, 8.0, 10.0, 12.0})
        scene.add({.mesh = scene.at(1).mesh, .material = scene.at(1).material, .to_world = at(x, 0, 0)});
    SceneGeometry surfaces;
    surfaces.update(scene);
    const std::size_t all = surfaces.geometry().positions.size();
    const std::size_t largest = scene.at(0).mesh->positions.size();
    REQUIRE(2 * largest < all);
    const glm::dmat3 axes = surfaces.own_axes();
    for (const double angle : {0.3, 0.7}) {
        scene.set_transform(0, glm::rotate(at(0, 5, angle), angle, glm::dvec3(1, 1, 0)));
        surfaces.update(scene);
        std::size_t kept = 0;
        for (const VertexRun& run : surfaces.change().kept) kept += run.last - run.first;
        CHECK(kept == all - largest);
        CHECK(surfaces.to_world() == glm::dmat4(1));
        CHECK(surfaces.own_axes() == axes);
    }
    // The whole scene moves, and nothing is disturbed.
    const Version version = surfaces.version();
    const glm::dmat4 motion = glm::rotate(at(1, 2, 3), 0.5, glm::dvec3(1, 1, 0));
    for (const auto id : scene.ids()) scene.set_transform(id, motion * scene.at(id).to_world);
    surfaces.update(scene);
    CHECK(surfaces.version() == version);
    for (int i = 0; i < 4; ++i) CHECK(glm::distance(surfaces.to_world()[i], motion[i]) < 1e-9);
}

TEST_CASE("an instance that deforms has moved, and the axes stay") {
    Scene scene = two_balls();
    SceneGeometry surfaces;
    surfaces.update(scene);
    const WorldGeometry before = surfaces.geometry();
    const glm::dmat3 axes = surfaces.own_axes();
    for (const std::uint32_t id : {0U, 1U}) {
        const Mesh& mesh = *scene.at(id).mesh;
        std::vector<glm::vec3> positions = mesh.positions;
        for (glm::vec3& p : positions) p.x *= 2;
        scene.set_mesh(id, std::make_shared<const Mesh>(deformed(mesh, std::move(positions), {})));
        surfaces.update(scene);
        const SceneGeometry::Change& change = surfaces.change();
        CHECK(surfaces.own_axes() == axes);
        CHECK(surfaces.to_world() == glm::dmat4(1));
        REQUIRE(change.moved.size() == 1);
        CHECK(change.moved[0].deformed);
        CHECK(change.moved[0].vertices.first == before.ranges[id].first);
        CHECK(change.moved[0].vertices.last == before.ranges[id].last);
        CHECK(change.moved[0].vertices.before == before.ranges[id].first);
        CHECK(change.kept.size() == 1);
        CHECK(surfaces.geometry().triangles == before.triangles);
    }
    // Another mesh is another instance to the bake.
    scene.set_mesh(1, coarse_sphere(3));
    surfaces.update(scene);
    CHECK(surfaces.change().moved.empty());
    CHECK(surfaces.change().kept.size() == 1);
}

TEST_CASE("a change reports what is kept and where the rest is") {
    Scene scene = two_balls();
    SceneGeometry surfaces;
    surfaces.update(scene);
    CHECK(surfaces.change().before == 0);
    const WorldGeometry before = surfaces.geometry();
    const Version first = surfaces.version();
    scene.set_transform(1, at(3, 1, 0));
    surfaces.update(scene);
    const WorldGeometry& after = surfaces.geometry();
    const SceneGeometry::Change& change = surfaces.change();
    CHECK(change.before == first);
    CHECK(surfaces.version() > first);
    REQUIRE(change.kept.size() == 1);
    CHECK(change.kept[0].first == 0);
    CHECK(change.kept[0].last == after.ranges[1].first);
    REQUIRE(change.added.size() == 1);
    REQUIRE(change.removed.size() == 1);
    for (std::size_t v = after.ranges[1].first; v < after.ranges[1].last; ++v) {
        CHECK(inside(change.added[0], after.positions[v]));
        CHECK(inside(change.removed[0], before.positions[v]));
    }

    scene.remove(0);
    surfaces.update(scene);
    REQUIRE(surfaces.geometry().ranges.size() == 1);
    CHECK(surfaces.geometry().ranges[0].instance == 1);
    // The remaining instance is now the largest, but was stored in other axes.
    CHECK(surfaces.to_world() == glm::dmat4(1));
    scene.remove(1);
    surfaces.update(scene);
    CHECK(surfaces.geometry().positions.empty());
}

TEST_CASE("materials change without the geometry, unless sides do") {
    Scene scene = two_balls();
    SceneGeometry surfaces;
    surfaces.update(scene);
    const Version geometry = surfaces.version();
    const Version materials = surfaces.material_version();
    const MaterialPtr other = diffuse({0.1});
    scene.set_material(1, other);
    surfaces.update(scene);
    CHECK(surfaces.version() == geometry);
    CHECK(surfaces.material_version() > materials);
    CHECK(surfaces.geometry().ranges[1].material == other);
    scene.set_material(1, twosided(other));
    surfaces.update(scene);
    CHECK(surfaces.version() > geometry);
    CHECK(surfaces.geometry().ranges.size() == 3);
    CHECK(surfaces.geometry().ranges[2].instance == 1);
}

TEST_CASE("emission outlives every change of the geometry") {
    Scene scene = two_balls();
    const auto emission = std::make_shared<const Emission>(Emission{.radiance = {2}});
    scene.set_emission(1, emission);
    SceneGeometry surfaces;
    surfaces.update(scene);
    const Version materials = surfaces.material_version();
    scene.set_transform(0, at(0.5, 0, 0));
    surfaces.update(scene);
    CHECK(surfaces.geometry().ranges[0].emission == nullptr);
    CHECK(surfaces.geometry().ranges[1].emission == emission);
    CHECK(surfaces.material_version() == materials);
    scene.hide_emitters(true);
    scene.set_transform(0, at(0, 0, 0));
    surfaces.update(scene);
    CHECK(surfaces.geometry().ranges[1].emission == nullptr);
}
