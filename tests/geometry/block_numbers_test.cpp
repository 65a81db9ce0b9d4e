// SPDX-License-Identifier: MIT
#include "geometry/block_numbers.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <numeric>

#include "geometry/mesh.hpp"
#include "simd/lanes.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

// Returns the vertices of a mesh by their numbers.
std::vector<std::size_t> by_number(const std::vector<std::uint32_t>& numbers) {
    std::vector<std::size_t> out(numbers.size(), numbers.size());
    for (std::size_t v = 0; v < numbers.size(); ++v) out[numbers[v]] = v;
    return out;
}

// Returns how many vertices are in blocks with a vertex that faces an eye far away, over those that do.
double excess(const Mesh& mesh, const std::vector<std::size_t>& order, const glm::vec3& to_eye) {
    std::size_t facing = 0, in_blocks = 0;
    for (std::size_t first = 0; first < order.size(); first += kLanes) {
        const std::size_t last = std::min(first + kLanes, order.size());
        std::size_t here = 0;
        for (std::size_t i = first; i < last; ++i)
            here += glm::dot(mesh.normals[order[i]], to_eye) > 0 ? 1 : 0;
        facing += here;
        in_blocks += here > 0 ? last - first : 0;
    }
    return static_cast<double>(in_blocks) / static_cast<double>(facing);
}

}  // namespace

TEST_CASE("block numbers are a permutation whose blocks face alike, from wherever a view looks") {
    Mesh mesh = make_sphere();
    // The order of a file may be any.
    std::mt19937 random(7);
    std::vector<std::size_t> shuffled(mesh.positions.size());
    std::iota(shuffled.begin(), shuffled.end(), std::size_t{0});
    std::ranges::shuffle(shuffled, random);
    const Mesh given = mesh;
    for (std::size_t v = 0; v < shuffled.size(); ++v) {
        mesh.positions[v] = 1.5F * given.positions[shuffled[v]];
        mesh.normals[v] = given.normals[shuffled[v]];
    }
    const std::vector<std::uint32_t> numbers = block_numbers(mesh.positions, mesh.normals);
    REQUIRE(numbers.size() == mesh.positions.size());
    const std::vector<std::size_t> order = by_number(numbers);
    CHECK(std::ranges::find(order, order.size()) == order.end());
    std::vector<std::size_t> given_order(order.size());
    std::iota(given_order.begin(), given_order.end(), std::size_t{0});
    for (const glm::vec3& to_eye : {glm::vec3(1, 0, 0), glm::vec3(0.3F, -2, 0.7F), glm::vec3(-1, 1, -1)}) {
        CHECK(excess(mesh, order, to_eye) < 1.15);
        CHECK(excess(mesh, given_order, to_eye) > 1.9);
    }
    // They depend on the shape alone, neither on its size nor on where it is; float has no size of the
    // largest.
    for (const float size : {4.0F, 0x1p127F}) {
        CAPTURE(size);
        std::vector<glm::vec3> positions = mesh.positions;
        for (glm::vec3& position : positions) position *= size;
        CHECK(block_numbers(positions, mesh.normals) == numbers);
    }
    // The positions of the smallest are rounded, and float has no inverse of their size.
    for (glm::vec3& position : mesh.positions) position *= 1e-39F;
    const auto small = by_number(block_numbers(mesh.positions, mesh.normals));
    CHECK(std::ranges::find(small, small.size()) == small.end());
    CHECK(excess(mesh, small, {1, 0, 0}) < 1.15);
}

TEST_CASE("blocks of a plane, whose normals are equal, are compact") {
    const Mesh mesh = make_rectangle(63);  // 64 x 64 vertices at a distance of 2 / 63
    const std::vector<std::size_t> order = by_number(block_numbers(mesh.positions, mesh.normals));
    double longest = 0;
    for (std::size_t first = 0; first < order.size(); first += kLanes)
        for (std::size_t i = first; i < first + kLanes; ++i)
            longest = std::max(longest,
                               double{glm::distance(mesh.positions[order[first]], mesh.positions[order[i]])});
    CHECK(longest < 2.0 / 63 * 3 * glm::root_two<double>() * 1.01);  // the diagonal of 4 x 4 vertices
}

TEST_CASE("few vertices, or vertices at one place, keep their order") {
    const std::vector<glm::vec3> place(kLeastOrdered, glm::vec3(1, 2, 3)),
        normal(kLeastOrdered, glm::vec3(0, 0, 1));
    CHECK(block_numbers(std::span(place).first(kLeastOrdered - 1), std::span(normal).first(kLeastOrdered - 1))
              .empty());
    CHECK(block_numbers({}, {}).empty());
    std::vector<std::uint32_t> given(kLeastOrdered);
    std::iota(given.begin(), given.end(), 0U);
    CHECK(block_numbers(place, normal) == given);
}
