// SPDX-License-Identifier: MIT
// Tests of the rays that added and removed objects may meet.
#include "visibility/disturbed_rays.hpp"

#include "test.hpp"

using namespace nicol;

namespace {

glm::vec3 random_unit(std::mt19937& random) {
    std::normal_distribution<float> normal;
    return glm::normalize(glm::vec3(normal(random), normal(random), normal(random)));
}

std::vector<Ball> random_balls(std::mt19937& random, std::size_t count) {
    std::uniform_real_distribution<float> radius(0.01F, 0.4F), distance(0.1F, 9);
    std::vector<Ball> balls(count);
    for (Ball& ball : balls) ball = {distance(random) * random_unit(random), radius(random)};
    return balls;
}

bool meets(const glm::dvec3& direction, const Ball& ball) {
    const glm::dvec3 centre(ball.centre);
    const double along = std::max(0.0, glm::dot(centre, direction));
    return glm::length(centre - along * direction) <= static_cast<double>(ball.radius);
}

}  // namespace

TEST_CASE("every ray that meets a ball is found, and few others") {
    std::mt19937 random(5);
    const DirectionSet directions(1024);
    for (const std::size_t count : {1U, 2U, 40U}) {
        std::size_t found = 0, met = 0;
        for (int turn = 0; turn < 20; ++turn) {
            const std::vector<Ball> added = random_balls(random, count);
            const std::vector<Ball> removed = random_balls(random, count / 2);
            const DisturbedRays rays(directions, {added, removed});
            const glm::vec3 normal = random_unit(random);
            DisturbedBundles bundles;
            const bool any = rays.find(glm::vec3(0), normal, bundles);
            bool set = false;
            for (std::size_t i = 0; i < directions.size(); ++i) {
                const bool closes = (bundles.may_close[i / 16] >> (i % 16) & 1) != 0;
                const bool opens = (bundles.may_open[i / 16] >> (i % 16) & 1) != 0;
                set = set || closes || opens;
                if (glm::dot(normal, directions.directions()[i]) <= 0) continue;
                const glm::dvec3 direction(directions.directions()[i]);
                const auto on_ray = [&](const Ball& ball) { return meets(direction, ball); };
                const bool met_added = std::ranges::any_of(added, on_ray);
                const bool met_removed = std::ranges::any_of(removed, on_ray);
                CHECK((closes || !met_added));
                CHECK((opens || !met_removed));
                found += (closes ? 1 : 0) + (opens ? 1 : 0);
                met += (met_added ? 1 : 0) + (met_removed ? 1 : 0);
            }
            CHECK(any == set);
        }
        CAPTURES(count, found, met);
        CHECK(met > 20 * count);
        CHECK(found < (count < 32 ? 2 : 4) * met);
    }
}

TEST_CASE("a point inside a ball finds the rays that meet the ball's box, and few others") {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> coordinate(-3, 3), size(0, 2);
    const DirectionSet directions(1024);
    std::size_t found = 0, met = 0;
    for (int turn = 0; turn < 40; ++turn) {
        Box box;
        for (glm::length_t k = 0; k < 3; ++k) {
            box.lower[k] = coordinate(random);
            // Some boxes are flat.
            box.upper[k] = box.lower[k] + (turn % 4 == k ? 0.0 : size(random));
        }
        const std::vector<Box> boxes{box};
        const std::vector<Ball> balls{{.centre = glm::vec3(0), .radius = 20}};
        const DisturbedRays rays(directions, {.added = balls, .removed = {}, .added_boxes = boxes});
        DisturbedBundles bundles;
        rays.find(glm::vec3(0), random_unit(random), bundles);
        for (std::size_t i = 0; i < directions.size(); ++i) {
            const glm::dvec3 direction(directions.directions()[i]);
            double first = 0, last = 1e9;
            for (glm::length_t k = 0; k < 3; ++k) {
                const double a = box.lower[k] / direction[k], b = box.upper[k] / direction[k];
                first = std::max(first, std::min(a, b));
                last = std::min(last, std::max(a, b));
            }
            const bool closes = (bundles.may_close[i / 16] >> (i % 16) & 1) != 0;
            CHECK((closes || first > last));
            found += closes ? 1 : 0;
            met += first <= last ? 1 : 0;
        }
    }
    CAPTURES(found, met);
    CHECK(met > 200);
    CHECK(found < met + met / 50 + 20);
}

TEST_CASE("a point inside a ball disturbs all rays, and nothing disturbs none") {
    const DirectionSet directions(256);
    DisturbedBundles bundles;
    const std::vector<Ball> around{{.centre = {0.1F, 0, 0}, .radius = 1}};
    CHECK(DisturbedRays(directions, {around, {}}).find({0, 0, 0}, {0, 0, 1}, bundles));
    for (const std::uint16_t some : bundles.may_close) CHECK(some == 0xFFFF);
    CHECK(!DisturbedRays(directions, {}).find({0, 0, 0}, {0, 0, 1}, bundles));
    const std::vector<Ball> below{{.centre = {0, 0, -3}, .radius = 1}};
    CHECK(!DisturbedRays(directions, {below, below}).find({0, 0, 0}, {0, 0, 1}, bundles));
}
