// SPDX-License-Identifier: MIT
#include "surfaces/rigid_motion.hpp"

#include "test.hpp"

using namespace nicol;

namespace {

glm::dmat4 some_motion() {
    return glm::rotate(glm::translate(glm::dmat4(1), {3, -2, 10}), 1.9, glm::dvec3(1, 2, -0.5));
}

glm::dmat4 some_placement() {
    return glm::scale(glm::rotate(glm::translate(glm::dmat4(1), {1, 7, -4}), 0.4, glm::dvec3(0, 2, 1)),
                      glm::dvec3(0.2, 5, 1));
}

}  // namespace

TEST_CASE("a rotation and a shift are found between placements") {
    const glm::dmat4 before = some_placement();
    const auto motion = rigid_motion(before, some_motion() * before);
    REQUIRE(motion);
    CHECK(largest(*motion - some_motion()) < 1e-12);
    CHECK(largest(inverse_motion(*motion) * some_motion() - glm::dmat4(1)) < 1e-12);
    CHECK(*rigid_motion(before, before) == glm::dmat4(1));
    // Engines store matrices in single precision.
    const auto coarse = rigid_motion(before, glm::dmat4(glm::mat4(some_motion() * before)));
    REQUIRE(coarse);
    CHECK(largest(*coarse - some_motion()) < 2e-5);
    const glm::dmat3 rotation(*coarse);
    CHECK(largest(glm::transpose(rotation) * rotation - glm::dmat3(1)) < 1e-14);
}

TEST_CASE("scales, shears and mirrors are no motions") {
    const glm::dmat4 before = some_placement();
    CHECK_FALSE(rigid_motion(before, glm::scale(before, glm::dvec3(1.0001))));
    CHECK_FALSE(rigid_motion(before, glm::scale(before, glm::dvec3(1, 1, -1))));
    glm::dmat4 shear(1);
    shear[1][0] = 1e-3;
    CHECK_FALSE(rigid_motion(before, before * shear));
    CHECK_FALSE(rigid_motion(before, shear * before));
}

TEST_CASE("the rotation in a matrix rotates with it, mirrored or not") {
    for (const double sign : {1.0, -1.0}) {
        const glm::dmat3 m = glm::dmat3(some_placement()) * glm::dmat3(sign, 0, 0, 0.3, 1, 0, 0, 0, 1e-6);
        const glm::dmat3 rotation = rotate_in(m);
        CHECK(largest(glm::transpose(rotation) * rotation - glm::dmat3(1)) < 1e-12);
        CHECK(glm::determinant(rotation) > 0);
        const glm::dmat3 more(some_motion());
        CHECK(largest(rotate_in(more * m) - more * rotation) < 1e-9);
        // The remaining factor is symmetric.
        const glm::dmat3 rest = glm::transpose(rotation) * m;
        CHECK(largest(rest - glm::transpose(rest)) < 1e-9);
    }
    CHECK(largest(rotate_in(glm::dmat3(1e-9)) - glm::dmat3(1)) < 1e-12);
}

TEST_CASE("a projection in other axes shows points at the same place") {
    Camera camera;
    camera.to_world = look_at({1, 2, 3}, {0, 0.5, 0}, {0, 1, 0});
    const Projection world = project(camera, 40, 30);
    const Projection own = in_axes(world, some_motion());
    const glm::dvec4 point(0.3, -0.2, 0.5, 1);
    const glm::dvec4 placed = some_motion() * point;
    CHECK(glm::distance(own.world_to_clip * point, world.world_to_clip * placed) < 1e-12);
    const glm::dvec3 towards = glm::dmat3(some_motion()) * own.view.towards(glm::dvec3(point));
    CHECK(glm::distance(towards, world.view.towards(glm::dvec3(placed))) < 1e-12);
    const glm::dmat3 frame = glm::dmat3(some_motion()) * own.view.frame(own.view.towards(glm::dvec3(point)));
    CHECK(largest(frame - world.view.frame(towards)) < 1e-12);
}
