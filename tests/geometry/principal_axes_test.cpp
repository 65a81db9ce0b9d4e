// SPDX-License-Identifier: MIT
#include "geometry/principal_axes.hpp"

#include <glm/gtc/quaternion.hpp>

#include "test.hpp"

using namespace nicol;

namespace {

void check_rotation(const glm::dmat3& axes) {
    CHECK(largest(glm::transpose(axes) * axes - glm::dmat3(1)) < 1e-12);
    CHECK(glm::determinant(axes) > 0.5);
}

// Returns points that spread most in x, less in y, and skewed to one side in both.
std::vector<glm::vec3> cloud(double scale) {
    std::mt19937 random(5);
    std::exponential_distribution<double> positive;
    std::vector<glm::vec3> points;
    for (int i = 0; i < 2000; ++i) {
        points.emplace_back(scale *
                            glm::dvec3{3 * positive(random), -2 * positive(random), 0.5 * positive(random)});
    }
    return points;
}

}  // namespace

TEST_CASE("axes lie along the points and rotate with them") {
    for (const double scale : {1e-7, 1.0, 1e7}) {
        const std::vector<glm::vec3> points = cloud(scale);
        const glm::dmat3 axes = principal_axes(points);
        check_rotation(axes);
        CHECK(axes[0].x > 0.95);
        CHECK(axes[1].y < -0.95);
        std::mt19937 random(7);
        std::normal_distribution<double> normal;
        for (int i = 0; i < 20; ++i) {
            const glm::dmat3 rotation = glm::mat3_cast(
                glm::normalize(glm::dquat{normal(random), normal(random), normal(random), normal(random)}));
            std::vector<glm::vec3> rotated;
            for (const glm::vec3& point : points) rotated.emplace_back(rotation * glm::dvec3(point));
            CHECK(largest(principal_axes(rotated) - rotation * axes) < 1e-5);
        }
    }
}

TEST_CASE("where no axes stand out there still is a rotation") {
    using Points = std::vector<glm::vec3>;
    const float huge = std::numeric_limits<float>::max();
    for (const Points& points :
         {Points{}, Points{{1, 2, 3}}, Points{{1, 2, 3}, {1, 2, 3}}, Points{{0, 0, 0}, {0, 0, 1}},
          Points{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}},
          Points{{huge, 0, 0}, {-huge, 1, 0}, {0, huge, -huge}}}) {
        check_rotation(principal_axes(points));
    }
}
