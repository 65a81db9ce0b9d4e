// SPDX-License-Identifier: MIT
// Tests of normals that turn while visibility lags behind.
#include "render/used_normals.hpp"

#include "test.hpp"
#include "visibility/visibility.hpp"

using namespace nicol;

namespace {

// Returns a unit vector by its angle from the z axis and around it.
glm::vec3 direction(double theta, double phi) {
    return glm::vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
}

}  // namespace

TEST_CASE("visibility is used anew once its frame has turned far") {
    struct Case {
        glm::vec3 before, now;
        bool deformed, kept;
    };
    const std::vector<Case> cases{
        {direction(1.2, 0.3), direction(1.2, 0.3), true, true},
        {direction(1.2, 0.3), direction(1.4, 0.3), true, true},
        {direction(1.2, 0.3), direction(1.5, 0.3), true, false},
        {direction(1.2, 0.3), direction(1.5, 0.3), false, true},  // such a vertex has an equal normal
        // The frame at the pole turns by more than the normal.
        {direction(0.05, 0.3), direction(0.05, 1.3), true, false},
    };
    std::vector<glm::vec3> before, now;
    std::vector<std::uint32_t> former;
    for (const Case& one : cases) {
        former.push_back(static_cast<std::uint32_t>(before.size()));
        before.push_back(one.before);
        now.push_back(one.now);
    }
    UsedNormals used;
    used.reset(before);
    const std::vector<std::uint8_t> same =
        used.follow(now, former, [&](std::uint32_t v) { return cases[v].deformed; });
    for (std::size_t v = 0; v < cases.size(); ++v) {
        CAPTURE(v);
        CHECK((same[v] == 0) == cases[v].deformed);
        CHECK((former[v] != kNoVertex) == cases[v].kept);
        CHECK(used.turned(v, now[v]) == (cases[v].kept && before[v] != now[v]));
    }
}

TEST_CASE("small turns add up") {
    UsedNormals used;
    used.reset(std::array{direction(1, 0)});
    const auto deformed = [](std::uint32_t) { return true; };
    for (int step = 1; step <= 2; ++step) {
        std::vector<std::uint32_t> former{0};
        CHECK(used.follow(std::array{direction(1 + 0.15 * step, 0)}, former, deformed)[0] == 0);
        CHECK((former[0] == 0) == (step == 1));
    }
}
