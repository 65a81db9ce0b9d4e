// SPDX-License-Identifier: MIT
#include "visibility/points_in_pixels.hpp"

#include "test.hpp"

using namespace nicol;

TEST_CASE("a point shares the pixel of the first point that is near and faces about the same way") {
    const glm::vec3 up(0, 0, 1), tilted(0, 0.1F, 0.995F), aside(1, 0, 0);
    const struct {
        const char* name;
        double pixel;
        glm::vec3 position, normal;
        bool shares;
    } cases[] = {{"the same point", 0.1, {0.51F, 0.52F, -0.53F}, up, true},
                 {"a near point", 0.1, {0.56F, 0.52F, -0.55F}, tilted, true},
                 {"a point of a neighbouring pixel", 0.1, {0.61F, 0.52F, -0.53F}, up, false},
                 {"a point that faces elsewhere", 0.1, {0.51F, 0.52F, -0.53F}, aside, false},
                 {"the back of the surface", 0.1, {0.51F, 0.52F, -0.53F}, -up, false},
                 {"the same point without pixels", 0, {0.51F, 0.52F, -0.53F}, up, false}};
    for (const auto& each : cases) {
        CAPTURE(each.name);
        PointsInPixels points(each.pixel);
        CHECK(points.add({0.51F, 0.52F, -0.53F}, up, 7) == 7);
        CHECK(points.add(each.position, each.normal, 8) == (each.shares ? 7 : 8));
        CHECK(points.add(each.position, each.normal, 9) == (each.pixel == 0 ? 9 : each.shares ? 7 : 8));
    }
}
