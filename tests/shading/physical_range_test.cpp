// SPDX-License-Identifier: MIT
#include "shading/physical_range.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("what is physical stays, what is not is moved into the range along its direction") {
    std::vector<glm::vec4> stokes{{1, 0.6F, 0, 0.8F}, {2, 1, -1, 1}, {0, 0, 0, 0},
                                  {1, 3, 0, 4},       {-1, 1, 2, 3}, {-2, 0, 0, 0}};
    const std::vector<glm::vec4> before = stokes;
    CHECK(make_physical(stokes) == 3);
    for (std::size_t i = 0; i < 3; ++i) CHECK(stokes[i] == before[i]);
    CHECK(glm::distance(stokes[3], glm::vec4(1, 0.6F, 0, 0.8F)) < 1e-6F);
    CHECK(stokes[4] == glm::vec4(0));
    CHECK(stokes[5] == glm::vec4(0));
}

TEST_CASE("moving keeps s0 and the angle, whatever the size of the numbers") {
    std::mt19937 random(11);
    std::normal_distribution<float> normal;
    for (const float scale : {1e-15F, 1.0F, 1e15F}) {
        std::vector<glm::vec4> stokes(1000);
        for (glm::vec4& s : stokes)
            s = scale * glm::vec4{normal(random), normal(random), normal(random), normal(random)};
        const std::vector<glm::vec4> before = stokes;
        make_physical(stokes);
        for (std::size_t i = 0; i < stokes.size(); ++i) {
            const glm::vec4& s = stokes[i];
            CHECK(s.x == std::max(before[i].x, 0.0F));
            CHECK(std::hypot(s.y, s.z, s.w) <= s.x * 1.000001F);
            CHECK(std::abs(s.y * before[i].z - s.z * before[i].y) <= 1e-5F * scale * scale);
        }
    }
}
