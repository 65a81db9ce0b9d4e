// SPDX-License-Identifier: MIT
#include "scene/pinhole.hpp"

#include <random>

#include "scene/projection.hpp"
#include "test.hpp"

using namespace nicol;
using doctest::Approx;

namespace {

constexpr int width = 640, height = 400;

Pinhole some_pinhole() {
    Pinhole p{.focal = {700, 690}, .middle = {300.25, 215.5}, .translation = {0.3, -0.2, 4}};
    // Turns of 0.4 and 0.3 about two axes.
    const double c = std::cos(0.4), s = std::sin(0.4), d = std::cos(0.3), u = std::sin(0.3);
    p.rotation = glm::dmat3(c, 0, -s, 0, 1, 0, s, 0, c) * glm::dmat3(1, 0, 0, 0, d, u, 0, -u, d);
    return p;
}

// Returns the position in the image from its upper left corner, in pixels.
glm::dvec2 pixel(const Camera& camera, const glm::dvec3& world) {
    const glm::dvec4 clip = project(camera, width, height).world_to_clip * glm::dvec4(world, 1);
    return {(clip.x / clip.w + 1) * 0.5 * width, (1 - clip.y / clip.w) * 0.5 * height};
}

}  // namespace

TEST_CASE("a pinhole camera puts points where K (R X + t) says, whose pixels begin at their middles") {
    const Pinhole pinhole = some_pinhole();
    const Camera camera = with_pinhole({}, pinhole, width, height);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-1, 1);
    for (int i = 0; i < 20; ++i) {
        const glm::dvec3 world(place(random), place(random), place(random));
        const glm::dvec3 seen = pinhole.rotation * world + pinhole.translation;
        const glm::dvec2 wanted = pinhole.focal * glm::dvec2(seen) / seen.z + pinhole.middle + 0.5;
        CHECK(glm::distance(pixel(camera, world), wanted) < 1e-9);
    }
}

TEST_CASE("a pinhole camera comes back from the camera that it became") {
    const Pinhole given = some_pinhole(),
                  back = pinhole_of(with_pinhole({}, given, width, height), width, height);
    CHECK(glm::distance(back.focal, given.focal) < 1e-9);
    CHECK(glm::distance(back.middle, given.middle) < 1e-9);
    CHECK(glm::distance(back.translation, given.translation) < 1e-12);
    for (int i = 0; i < 3; ++i) CHECK(glm::distance(back.rotation[i], given.rotation[i]) < 1e-12);
}

TEST_CASE("what is no pinhole camera is refused by name") {
    const auto refused = [](const char* text, auto change) {
        CAPTURE(text);
        Pinhole wrong = some_pinhole();
        change(wrong);
        CHECK(
            error_of(CALL(with_pinhole({}, wrong, width, height)), ErrorCode::invalid_argument).find(text) !=
            std::string::npos);
    };
    refused("focal", [](Pinhole& p) { p.focal.y = 0; });
    refused("focal", [](Pinhole& p) { p.focal.x = NAN; });
    refused("principal point", [](Pinhole& p) { p.middle.x = INFINITY; });
    refused("shift", [](Pinhole& p) { p.middle.x = 1e9; });
    refused("pixel_aspect", [](Pinhole& p) { p.focal.y = 1e6; });
    refused("R is no rotation", [](Pinhole& p) { p.rotation[1] *= 1.01; });
    refused("R is no rotation", [](Pinhole& p) { p.rotation[1][2] = NAN; });
    refused("mirrors", [](Pinhole& p) { p.rotation[1] *= -1.0; });
    refused("t must", [](Pinhole& p) { p.translation.z = NAN; });
    Camera parallel;
    parallel.orthographic = true;
    CHECK_THROWS_AS(static_cast<void>(pinhole_of(parallel, width, height)), Error);
}

TEST_CASE("a camera that frames a box has all of it in its image, which it touches at two opposite edges") {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> place(-5, 5), size(0, 3);
    for (int i = 0; i < 40; ++i) {
        CAPTURE(i);
        Camera camera;
        camera.orthographic = i % 4 == 3;
        camera.to_world = look_at({place(random), place(random), place(random)}, {0, 0, 0}, {0.1, 1, 0});
        camera.fov = 10 + 3 * i;
        camera.shift = {0.02 * (i % 5), -0.03 * (i % 3)};
        camera.pixel_aspect = i % 2 == 0 ? 1 : 1.3;
        const glm::dvec3 lower(place(random), place(random), place(random));
        const glm::dvec3 upper =
            lower + glm::dvec3(size(random), size(random), i % 5 == 0 ? 0 : size(random));
        const Camera framed = framing(camera, lower, upper, width, height);
        const Projection p = project(framed, width, height);
        for (int axis = 0; axis < 3; ++axis)  // not turned
            CHECK(glm::distance(glm::normalize(framed.to_world[axis]),
                                glm::normalize(camera.to_world[axis])) < 1e-12);
        glm::dvec2 least(1e9), most(-1e9);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec4 clip = p.world_to_clip * glm::dvec4((corner & 1) != 0 ? upper.x : lower.x,
                                                                 (corner & 2) != 0 ? upper.y : lower.y,
                                                                 (corner & 4) != 0 ? upper.z : lower.z, 1);
            REQUIRE(clip.w > 0);
            CHECK((clip.z >= 0 && clip.z <= clip.w));
            const glm::dvec2 at = glm::dvec2(clip) / clip.w;
            least = glm::min(least, at);
            most = glm::max(most, at);
        }
        CHECK((least.x > -1 - 1e-9 && least.y > -1 - 1e-9 && most.x < 1 + 1e-9 && most.y < 1 + 1e-9));
        const glm::dvec2 extent = most - least;
        CHECK(std::max(extent.x, extent.y) == Approx(2));
    }
}

TEST_CASE("a box that is none, and a camera that sees nothing, cannot be framed") {
    CHECK_THROWS_AS(static_cast<void>(framing({}, {0, 0, 0}, {0, 0, 0}, width, height)), Error);
    CHECK_THROWS_AS(static_cast<void>(framing({}, {0, 0, 0}, {1, -1, 1}, width, height)), Error);
    CHECK_THROWS_AS(static_cast<void>(framing({}, {0, 0, 0}, {INFINITY, 1, 1}, width, height)), Error);
    Camera closed;
    closed.fov = 0;
    CHECK_THROWS_AS(static_cast<void>(framing(closed, {0, 0, 0}, {1, 1, 1}, width, height)), Error);
    Camera endless;
    endless.far_clip = INFINITY;
    CHECK(std::isinf(framing(endless, {0, 0, 0}, {1, 1, 1}, width, height).far_clip));
}
