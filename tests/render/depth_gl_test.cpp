// SPDX-License-Identifier: MIT
// Tests of hidden surfaces: near clip planes and large distances do not let hidden ones show.
#include "gl/contexts.hpp"
#include "render/scenes.hpp"

using namespace nicol;

namespace {

/// Returns a bright wall at `distance` in front of the camera, and a black wall behind it, wider than the
/// image.
Scene walls(double distance, double gap) {
    Scene scene;
    for (const double behind : {gap, 0.0}) {
        const glm::dvec3 place{0.1 * distance, 0, -distance - behind};
        scene.add({.mesh = test::rectangle(7),
                   .material = diffuse({behind > 0 ? 0.0 : 0.8}),
                   .to_world = test::at(place.x, place.y, place.z, 2 * distance)});
    }
    scene.set_environment(constant_environment({1.0}), glm::dmat3(1), 1);
    return scene;
}

}  // namespace

IMAGE_TEST_CASE("a hidden surface does not show, whatever the distance and the near plane") {
    const struct {
        double distance, gap, near, far;
        bool orthographic;
    } rows[] = {{1000, 0.2, 1e-2, 1e4, false},     {1000, 0.02, 1e-2, 1e4, false},
                {1000, 0.2, 1e-8, 1e4, false},     {5, 1e-4, 1e-30, 1e4, false},
                {9000, 2, 1e-2, 1e4, false},       {1000, 0.2, 1e-2, HUGE_VAL, false},
                {1e6, 200, 1e-2, HUGE_VAL, false}, {1000, 0.2, 1e-2, 1e4, true}};
    for (const auto& row : rows) {
        CAPTURES(row.distance, row.gap, row.near, row.far, row.orthographic);
        Camera camera = test::camera_at({0, 0, 0}, {0.3, 0.2, -1});
        camera.near_clip = row.near;
        camera.far_clip = row.far;
        camera.orthographic = row.orthographic;
        if (row.orthographic) camera.to_world = camera.to_world * glm::dmat4(glm::dmat3(row.distance / 10));
        for (const ShadeAt where : {ShadeAt::vertices, ShadeAt::pixels}) {
            test::Studio render(context, 40, 30);
            const StokesImage image =
                render(walls(row.distance, row.gap),
                       {.shadows = false, .order_low = 2, .order_high = 2, .shade_at = where}, camera);
            std::size_t hidden_shown = 0;
            for (int y = 0; y < 30; ++y)
                for (int x = 0; x < 40; ++x) hidden_shown += image.at(0, y, x)[0] < 0.4F;
            CHECK(hidden_shown == 0);
        }
    }
}

TEST_CASE("an orthographic camera has a far plane, a perspective one need not") {
    Camera camera;
    camera.far_clip = HUGE_VAL;
    CHECK(project(camera, 4, 4).far_clip == HUGE_VAL);
    camera.orthographic = true;
    check_error(ErrorCode::invalid_argument, CALL(project(camera, 4, 4)), "far_clip");
}
