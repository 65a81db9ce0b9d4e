// SPDX-License-Identifier: MIT
// Test of the look-up of directions: each direction of another set finds one that is near it.
#include "transfer/nearest_directions.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "test.hpp"

using namespace nicol;

TEST_CASE("the nearest direction of a set is near, however many the set has") {
    const DirectionSet asked(1000);
    const struct {
        int count;
        float distance;
    } rows[] = {{256, 0.3F}, {1000, 0.2F}, {2048, 0.15F}, {16384, 0.15F}};
    for (const auto& row : rows) {
        CAPTURE(row.count);
        const DirectionSet set(row.count);
        const NearestDirections nearest(set);
        float worst = 1;
        for (const glm::vec3& direction : asked.directions())
            worst = std::min(worst, glm::dot(direction, set.directions()[nearest.of(3.0F * direction)]));
        CHECK(worst > std::cos(row.distance));
    }
}
