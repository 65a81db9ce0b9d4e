// SPDX-License-Identifier: MIT
#include "render/bake_order.hpp"

#include <set>

#include "render/scenes.hpp"
#include "surfaces/scene_geometry.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

/// A ball of which a camera sees one half, and a change that touches all of it.
struct BallInView {
    BallInView() {
        scene.add({.mesh = test::coarse_sphere(8), .material = diffuse({0.5})});
        surfaces.update(scene);
        const std::size_t vertices = surfaces.geometry().positions.size();
        parts.assign(vertices, 1.0F);
        waits.assign(vertices, 0);
    }

    [[nodiscard]] std::vector<std::uint32_t> order() const {
        return bake_order(surfaces.geometry(), {&projection, 1}, parts, waits);
    }

    /// Returns whether an image shows a vertex of the block.
    [[nodiscard]] bool sees(std::uint32_t block) const {
        std::vector<std::uint8_t> seen;
        find_visible(surfaces.geometry(), projection, seen);
        const std::size_t first = std::size_t{block} * kLanes, last = std::min(first + kLanes, seen.size());
        return std::any_of(seen.begin() + static_cast<std::ptrdiff_t>(first),
                           seen.begin() + static_cast<std::ptrdiff_t>(last),
                           [](std::uint8_t s) { return s != 0; });
    }

    Scene scene;
    SceneGeometry surfaces;
    Projection projection = project(test::some_camera(), 64, 48);
    std::vector<float> parts;
    std::vector<std::uint8_t> waits;
};

}  // namespace

TEST_CASE("the nearest and visible vertices are traced first") {
    BallInView ball;
    const std::size_t blocks = (ball.parts.size() + 15) / 16;
    std::vector<std::uint32_t> order = ball.order();
    CHECK(order.size() == blocks);
    CHECK(ball.sees(order.front()));
    CHECK(!ball.sees(order.back()));
    // A block that more of the change touches comes first.
    const std::size_t second = order[1];
    for (std::size_t v = second * kLanes; v < std::min((second + 1) * kLanes, ball.parts.size()); ++v)
        ball.parts[v] = 2;
    CHECK(ball.order().front() == second);

    const Ball near{.centre = glm::vec3(0, 0, 3), .radius = 1};
    const Disturbances change{.added = {&near, 1}, .removed = {}};
    CHECK(part_of_sky(glm::vec3(0, 0, 3.5F), change) == 1);
    CHECK(part_of_sky(glm::vec3(0, 0, 1), change) == doctest::Approx(0.25));
    CHECK(part_of_sky(glm::vec3(0), {}) == 0);
}

TEST_CASE("where everything changes again and again, each block that is seen has its turn") {
    BallInView ball;
    std::set<std::uint32_t> waiting;
    for (const std::uint32_t block : ball.order())
        if (ball.sees(block)) waiting.insert(block);
    const std::size_t blocks = waiting.size();
    REQUIRE(blocks > 4);
    std::size_t turns = 0;
    for (; turns < 2 * blocks && !waiting.empty(); ++turns) {
        const std::uint32_t first = ball.order().front();
        waiting.erase(first);
        for (std::uint8_t& wait : ball.waits) ++wait;
        for (std::size_t v = first * kLanes; v < std::min((first + 1) * kLanes, ball.waits.size()); ++v)
            ball.waits[v] = 0;
    }
    CHECK(turns == blocks);
}
