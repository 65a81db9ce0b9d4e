// SPDX-License-Identifier: MIT
// Tests of the triangles that images show, and of lobes at grazing angles.
#include "render/seen_triangles.hpp"

#include "render/grazing_lobes.hpp"
#include "render/scenes.hpp"
#include "scene/camera.hpp"
#include "surfaces/scene_geometry.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

// A square of two triangles, which faces +y.
std::shared_ptr<const Mesh> floor_of(float half) {
    Mesh mesh;
    mesh.positions = {{-half, 0, -half}, {-half, 0, half}, {half, 0, half}, {half, 0, -half}};
    mesh.normals.assign(4, glm::vec3(0, 1, 0));
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return std::make_shared<const Mesh>(std::move(mesh));
}

Projection from_height(double height, bool orthographic = false) {
    Camera camera = test::camera_at({0.3, height, 4}, {0, 0, 0});
    camera.fov = 40;
    camera.orthographic = orthographic;
    return project(camera, 64, 64);
}

// Returns the share of an image's places that show the floor below a cosine.
double counted(const Projection& projection, double half, double grazing) {
    constexpr int side = 400;
    const Viewpoint& view = projection.view;
    int found = 0;
    for (int k = 0; k < side * side; ++k) {
        const glm::dvec2 at =
            on_image_plane(projection, side, side, k % side + 0.5, static_cast<double>(k / side) + 0.5);
        const glm::dvec3 across = at.x * view.right + at.y * view.up;
        const glm::dvec3 start = view.orthographic ? view.eye + across : view.eye;
        const glm::dvec3 way = view.orthographic ? view.forward : view.forward + across;
        const double distance = -start.y / way.y;
        const glm::dvec3 place = start + distance * way;
        if (distance > 0 && std::max(std::abs(place.x), std::abs(place.z)) < half && -way.y < grazing)
            ++found;
    }
    return static_cast<double>(found) / (side * side);
}

}  // namespace

TEST_CASE("a triangle's share of an image is what the image shows of it") {
    for (const bool orthographic : {false, true})
        for_all(
            {0.2, 1.0, 3.0}, {1.0, 3.0, 1e4}, {1.0, 0.3, 0.1},
            [orthographic](double height, double half, double grazing) {
                const Projection projection = from_height(height, orthographic);
                const auto mesh = floor_of(static_cast<float>(half));
                double share = 0;
                for (const glm::uvec3& t : mesh->triangles) {
                    const std::array corners{mesh->positions[t.x], mesh->positions[t.y],
                                             mesh->positions[t.z]};
                    share += shown_share(projection, corners, grazing);
                    CHECK(shown_share(projection, {corners[0], corners[2], corners[1]}) == 0);  // the back
                }
                CAPTURES(height, half, orthographic, grazing);
                CHECK(share == doctest::Approx(counted(projection, half, grazing)).epsilon(0.01).scale(0.5));
            });
}

TEST_CASE("a sample of triangles stands for all, and has the few large ones") {
    Scene scene;
    scene.add(
        {.mesh = test::coarse_sphere(100), .material = diffuse({0.5}), .to_world = test::at(0, 0.3, 0)});
    scene.add({.mesh = floor_of(3), .material = diffuse({0.5})});
    SceneGeometry surfaces;
    surfaces.update(scene);
    const WorldGeometry& geometry = surfaces.geometry();
    REQUIRE(geometry.triangles.size() > 10'000);
    SeenTriangles seen;
    seen.update(geometry, 1);
    const Projection projection = from_height(1);
    const auto is_floor = [&](const glm::uvec3& t) { return range_of(geometry, t.x) == 1; };
    std::array<double, 2> all{}, sampled{};
    int count = 0;
    for (const glm::uvec3& t : geometry.triangles)
        all[is_floor(t) ? 1 : 0] += shown_share(
            projection, {geometry.positions[t.x], geometry.positions[t.y], geometry.positions[t.z]});
    seen.for_each(geometry, projection, [&](std::size_t i, double share) {
        sampled[is_floor(geometry.triangles[i]) ? 1 : 0] += share;
        ++count;
    });
    CHECK(count < 2500);
    CHECK(all[0] > 0.05);
    CHECK(sampled[0] == doctest::Approx(all[0]).epsilon(0.05));
    CHECK(sampled[1] == doctest::Approx(all[1]).epsilon(0.01));
}

TEST_CASE("lobes are sampled where a large part of an image shows them at grazing angles") {
    const struct {
        MaterialPtr material;
        double half, height;
        double narrowest;
    } rows[] = {{test::some_metal(0.2), 1e4, 0.5, 0.2}, {twosided(test::some_metal(0.2)), 1e4, 0.5, 0.2},
                {test::some_metal(0.2), 1e4, 4, 0.1},   {test::some_metal(0.2), 0.3, 0.5, 0.1},
                {test::some_metal(0.5), 1e4, 0.5, 0.1}, {test::some_metal(0.05), 1e4, 0.5, 0.1},
                {diffuse({0.5}), 1e4, 0.5, 0.1}};
    for (const auto& row : rows) {
        Scene scene;
        scene.add({.mesh = floor_of(static_cast<float>(row.half)), .material = row.material});
        SceneGeometry surfaces;
        surfaces.update(scene);
        SeenTriangles seen;
        seen.update(surfaces.geometry(), 1);
        const double found = narrowest_in_harmonics(surfaces.geometry(), seen, from_height(row.height));
        CAPTURES(row.half, row.height, row.narrowest, found);
        CHECK(found == doctest::Approx(row.narrowest));
        CHECK(found >= row.narrowest);  // lobes of this width are narrower
    }
}
