// SPDX-License-Identifier: MIT
#include "scene/projection.hpp"
#include "test.hpp"

using namespace nicol;
using doctest::Approx;

namespace {

// Returns the position in the image (-1 to 1, to the right and up) and the depth.
glm::dvec3 in_image(const Projection& p, const glm::dvec3& world) {
    const glm::dvec4 clip = p.world_to_clip * glm::dvec4(world, 1);
    return glm::dvec3(clip) / clip.w;
}

}  // namespace

TEST_CASE("look_at makes Mitsuba's camera space: z forward, y up, x to the left") {
    const glm::dmat4 m = look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0});
    CHECK(glm::dvec3(m[2]) == glm::dvec3(0, 0, -1));
    CHECK(glm::dvec3(m[1]) == glm::dvec3(0, 1, 0));
    CHECK(glm::dvec3(m[0]) == glm::dvec3(-1, 0, 0));
    CHECK(glm::dvec3(m[3]) == glm::dvec3(0, 0, 5));
    CHECK_THROWS_AS(static_cast<void>(look_at({0, 0, 0}, {0, 0, 0}, {0, 1, 0})), Error);
    CHECK_THROWS_AS(static_cast<void>(look_at({0, 0, 0}, {0, 2, 0}, {0, 1, 0})), Error);
}

TEST_CASE("a perspective camera puts the edge of its horizontal field of view at the image's edge") {
    Camera camera;
    camera.to_world = look_at({1, 2, 3}, {1, 2, 2}, {0, 1, 0});
    camera.fov = 90;
    camera.near_clip = 0.5;
    camera.far_clip = 100;
    const Projection p = project(camera, 200, 100);
    CHECK(in_image(p, {3, 2, 1}).x == Approx(1));  // two units to the right, two ahead
    CHECK(in_image(p, {1, 3, 1}).y == Approx(1));  // the height is half the width
    CHECK(in_image(p, {-1, 2, 1}).x == Approx(-1));
    CHECK(in_image(p, {1, 2, 2.5}).z == Approx(1));  // at the near clip
    CHECK(in_image(p, {1, 2, -97}).z == Approx(0));  // at the far clip
    CHECK(p.half_width == Approx(1));
    CHECK(p.half_height == Approx(0.5));
    CHECK(glm::distance(p.view.right, glm::dvec3(1, 0, 0)) < 1e-15);
}

TEST_CASE("an orthographic camera's half width is the length of its x axis") {
    Camera camera;
    camera.orthographic = true;
    camera.to_world = look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}) *
                      glm::dmat4(1.25, 0, 0, 0, 0, 1.25, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
    const Projection p = project(camera, 128, 128);
    CHECK(in_image(p, {1.25, 0, 0}).x == Approx(1));
    CHECK(in_image(p, {0, -1.25, -3}).y == Approx(-1));
    CHECK(p.view.towards({7, 8, 9}) == glm::dvec3(0, 0, 1));
}

TEST_CASE("jitter moves an image by a part of a pixel, the plane of its rays as what is drawn") {
    for (const bool orthographic : {false, true}) {
        Camera camera;
        camera.orthographic = orthographic;
        camera.to_world = look_at({1, 2, 3}, {2, 2, -4}, {0, 1, 0});
        const Projection still = project(camera, 40, 20);
        camera.jitter = {0.5, -0.25};
        const Projection moved = project(camera, 40, 20);
        const glm::dvec2 centre = on_image_plane(moved, 40, 20, 7.5, 3.5);
        CHECK(glm::distance(centre, on_image_plane(still, 40, 20, 8, 3.25)) < 1e-12);
        const Viewpoint& view = moved.view;
        const glm::dvec3 image =
            in_image(moved, view.eye + 5.0 * view.forward +
                                (orthographic ? 1.0 : 5.0) * (centre.x * view.right + centre.y * view.up));
        CHECK(image.x == Approx(2 * 7.5 / 40 - 1));
        CHECK(image.y == Approx(1 - 2 * 3.5 / 20));
    }
}

TEST_CASE("cameras out of range are refused by the name of the member") {
    const auto refused = [](const char* part, auto change) {
        Camera camera;
        change(camera);
        check_error(ErrorCode::invalid_argument, CALL(project(camera, 100, 50)), part);
    };
    refused("fov", [](Camera& c) { c.fov = 180; });
    refused("pixel_aspect", [](Camera& c) { c.pixel_aspect = 0; });
    refused("pixel_aspect", [](Camera& c) { c.pixel_aspect = NAN; });
    refused("fov", [](Camera& c) { c.fov = std::nan(""); });
    refused("near_clip", [](Camera& c) { c.near_clip = 0; });
    refused("far_clip", [](Camera& c) { c.far_clip = c.near_clip; });
    refused("right angles", [](Camera& c) { c.to_world[0] = {1, 1, 0, 0}; });
    refused("mirrors", [](Camera& c) { c.to_world[0] = -c.to_world[0]; });
    refused("without length", [](Camera& c) { c.to_world[2] = {0, 0, 0, 0}; });
    refused("finite", [](Camera& c) { c.to_world[3].x = HUGE_VAL; });
    refused("jitter", [](Camera& c) { c.jitter.x = 0.51; });
    refused("jitter", [](Camera& c) { c.jitter.y = std::nan(""); });
    refused("shift", [](Camera& c) { c.shift.x = -2e5; });
    refused("shift", [](Camera& c) { c.shift.y = HUGE_VAL; });
    refused("last row", [](Camera& c) { c.to_world[3].w = 2; });
}
