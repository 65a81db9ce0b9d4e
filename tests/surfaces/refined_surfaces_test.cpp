// SPDX-License-Identifier: MIT
#include "surfaces/refined_surfaces.hpp"

#include "render/scenes.hpp"
#include "test.hpp"

using namespace nicol;
using test::at;

namespace {

// Returns a refinement of the first triangle that halves its first edge, then one half, and so on.
Refinement halved(const WorldGeometry& geometry, std::uint32_t times) {
    Refinement out;
    const glm::uvec3 corners = geometry.triangles.front();
    std::uint32_t end = corners.y;
    for (std::uint32_t i = 0; i < times; ++i) {
        const auto middle = static_cast<std::uint32_t>(geometry.positions.size()) + i;
        out.parents.emplace_back(corners.x, end);
        out.triangles.emplace_back(middle, end, corners.z);
        end = middle;
    }
    out.triangles.emplace_back(corners.x, end, corners.z);
    out.sources.assign(out.triangles.size(), 0);
    for (std::uint32_t t = 1; t < geometry.triangles.size(); ++t) {
        out.triangles.push_back(geometry.triangles[t]);
        out.sources.push_back(t);
    }
    return out;
}

}  // namespace

TEST_CASE("a few added vertices more leave the numbers of other ranges as they are") {
    Scene scene;
    scene.add({.mesh = test::rectangle(2), .material = diffuse({0.5}), .to_world = at(0, 0, 0)});
    scene.add({.mesh = test::rectangle(2), .material = diffuse({0.5}), .to_world = at(0, 0, 3)});
    SceneGeometry surfaces;
    surfaces.update(scene);
    const WorldGeometry& given = surfaces.geometry();
    constexpr std::uint64_t any = 1 << 20;
    const RefinedGeometry few = refined(given, halved(given, 3), any);
    const RefinedGeometry more = refined(given, halved(given, 9), any);
    REQUIRE(few.geometry.ranges.size() == 2);
    CHECK(few.geometry.ranges[1].first == more.geometry.ranges[1].first);
    CHECK(few.geometry.ranges[1].last == more.geometry.ranges[1].last);
    CHECK(few.geometry.positions.size() == given.positions.size() + 16);
    for (const RefinedGeometry* const one : {&few, &more}) {
        const VertexNumbers& numbers = one->numbers;
        for (std::size_t i = 0; i < numbers.numbers.size(); ++i)
            CHECK(numbers.source(numbers.number(i)) == i);
        for (std::uint32_t v = 0; v + 1 < one->geometry.positions.size(); ++v) {
            CAPTURE(v);
            CHECK((numbers.next_copy(v) == v + 1) == numbers.is_copy(v + 1));
            if (!numbers.is_copy(v + 1)) continue;
            CHECK(one->geometry.positions[v + 1] == one->geometry.positions[v]);
            CHECK(v + 1 < one->geometry.ranges[0].last);
        }
        for (const glm::uvec3& triangle : one->geometry.triangles)
            for (const std::uint32_t v : {triangle.x, triangle.y, triangle.z}) CHECK(!numbers.is_copy(v));
    }
    // The range has no reserve where it would exceed the largest number of vertices.
    const RefinedGeometry full = refined(given, halved(given, 3), given.positions.size() + 15);
    CHECK(full.geometry.positions.size() == given.positions.size() + 3);
}
