// SPDX-License-Identifier: MIT
#include "shading/realizable_range.hpp"
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

TEST_CASE("light as weak as its noise is less polarized, bright light as before") {
    const float noise = 0.01F;
    std::vector<glm::vec4> stokes{
        {1, 0.6F, 0, 0.8F}, {0.01F, 0.004F, 0, 0}, {0.001F, 0.1F, 0, 0}, {0, 0, 0.2F, 0}, {-1, 1, 0, 0}};
    CHECK(make_physical(stokes, noise) == 3);
    CHECK(glm::distance(stokes[0], glm::vec4(1, 0.6F, 0, 0.8F)) < 2e-4F);
    CHECK(glm::distance(stokes[1], glm::vec4(0.01F, 0.002F, 0, 0)) < 1e-7F);
    CHECK(stokes[2].x == 0.001F);
    CHECK(stokes[2].y == doctest::Approx(0.001 / 101));
    CHECK(stokes[3] == glm::vec4(0));
    CHECK(stokes[4] == glm::vec4(0));
}

TEST_CASE("the factor is that of the least squared error, and never worse than none") {
    // True light of intensity `strength`, half linearly polarized at varying angles, plus random noise in the
    // linear components.
    std::mt19937 random(2);
    std::normal_distribution<float> normal;
    for (const float strength : {0.3F, 1.0F, 3.0F}) {
        double plain = 0;
        double shortened = 0;
        for (int i = 0; i < 20000; ++i) {
            const glm::vec4 truth(strength, 0.5F * strength * std::cos(static_cast<float>(i)),
                                  0.5F * strength * std::sin(static_cast<float>(i)), 0);
            const glm::vec4 found(truth.x, truth.y + normal(random), truth.z + normal(random), 0);
            std::array with{found};
            std::array without{found};
            make_physical(with, 1);
            make_physical(without);
            const auto error = [&](const glm::vec4& s) {
                return std::pow(static_cast<double>(glm::distance(s, truth)), 2);
            };
            plain += error(without[0]);
            shortened += error(with[0]);
        }
        CAPTURE(strength);
        CHECK(shortened < plain);
    }
}
