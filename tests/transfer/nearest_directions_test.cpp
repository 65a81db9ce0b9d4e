// SPDX-License-Identifier: MIT
// Test of the look-up of directions: each direction of another set finds one that is near.
#include "transfer/nearest_directions.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "test.hpp"

using namespace nicol;

TEST_CASE("the nearest direction of a set is near, however many the set has") {
    const DirectionSet asked(1000);
    for (const int count : {2048, 16384}) {
        CAPTURE(count);
        const DirectionSet set(count);
        const NearestDirections nearest(set);
        float worst = 1;
        for (const glm::vec3& direction : asked.directions())
            worst = std::min(worst, glm::dot(direction, set.directions()[nearest.of(3.0F * direction)]));
        CHECK(worst > std::cos(0.15F));
    }
}
