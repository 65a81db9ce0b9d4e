// SPDX-License-Identifier: MIT
#include "geometry/edge_bisection.hpp"

#include <map>
#include <random>

#include "measures.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

Mesh mesh_of(const EdgeBisection& bisection) {
    return {.positions = bisection.positions(), .normals = {}, .triangles = bisection.triangles()};
}

/// Counts the triangles at each edge.
std::map<EdgeBisection::Edge, int> triangles_at_edges(const EdgeBisection& bisection) {
    std::map<EdgeBisection::Edge, int> counts;
    for (const glm::uvec3& t : bisection.triangles())
        for (glm::length_t k = 0; k < 3; ++k) ++counts[bisection.edge(t[k], t[(k + 1) % 3])];
    return counts;
}

double smallest_angle(const Mesh& mesh) {
    double least = pi;
    for (const glm::uvec3& t : mesh.triangles) {
        for (glm::length_t k = 0; k < 3; ++k) {
            const glm::dvec3 here(mesh.positions[t[k]]);
            const glm::dvec3 u = glm::normalize(glm::dvec3(mesh.positions[t[(k + 1) % 3]]) - here);
            const glm::dvec3 v = glm::normalize(glm::dvec3(mesh.positions[t[(k + 2) % 3]]) - here);
            least = std::min(least, std::acos(std::clamp(glm::dot(u, v), -1.0, 1.0)));
        }
    }
    return least;
}

/// Splits some edges repeatedly.
void split_some(EdgeBisection& bisection, int rounds, std::vector<WantedLength>& points) {
    std::mt19937 random(7);
    for (int round = 0; round < rounds; ++round) {
        EdgeBisection::Edges edges;
        for (const glm::uvec3& t : bisection.triangles())
            if (random() % 5 == 0) edges.insert(bisection.edge(t.x, t.y));
        bisection.close(edges);
        const std::size_t cost = bisection.cost(edges);
        const std::size_t before = bisection.positions().size();
        bisection.split(edges, points);
        CHECK(bisection.positions().size() == before + cost);
    }
}

/// Returns three triangles at one edge, one of them without area, and a triangle without extent.
Mesh fan() {
    return {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.4F, 0, 0}, {1, 0, 0}},
            .normals = {},
            .triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 5, 5}}};
}

}  // namespace

TEST_CASE("bisection keeps surfaces, closed ones closed, and angles large") {
    for (const Mesh& mesh : {make_cube(1), make_cube(3), make_sphere(), make_rectangle(1)}) {
        EdgeBisection bisection(mesh.positions, mesh.triangles);
        const auto before = triangles_at_edges(bisection);
        std::vector<WantedLength> points;
        split_some(bisection, 4, points);
        const Mesh after = mesh_of(bisection);
        CAPTURES(mesh.positions.size(), after.positions.size());
        CHECK(after.triangles.size() > mesh.triangles.size());
        CHECK(area(after) == doctest::Approx(area(mesh)).epsilon(1e-5));
        CHECK(volume(after) == doctest::Approx(volume(mesh)).epsilon(1e-5));
        CHECK(smallest_angle(after) > 0.499 * smallest_angle(mesh));
        CHECK(bisection.parents().size() == after.positions.size() - mesh.positions.size());
        CHECK(std::ranges::is_sorted(bisection.sources()));
        // A midpoint on an edge that a neighbour does not split would leave edges with a single triangle.
        const bool closed = std::ranges::all_of(before, [](const auto& edge) { return edge.second == 2; });
        int open = 0;
        for (const auto& [edge, count] : triangles_at_edges(bisection)) open += count == 2 ? 0 : 1;
        CHECK((open == 0) == closed);
    }
}

TEST_CASE("every vertex is where its parents say and every triangle inside its source") {
    const Mesh mesh = make_cube(2);
    EdgeBisection bisection(mesh.positions, mesh.triangles);
    std::vector<WantedLength> points;
    split_some(bisection, 5, points);
    const std::vector<glm::vec3>& positions = bisection.positions();
    for (std::size_t i = 0; i < bisection.parents().size(); ++i) {
        const glm::uvec2 parents = bisection.parents()[i];
        const std::size_t vertex = mesh.positions.size() + i;
        CHECK(std::max(parents.x, parents.y) < vertex);
        CHECK(positions[vertex] == 0.5F * positions[parents.x] + 0.5F * positions[parents.y]);
    }
    std::vector<double> areas(mesh.triangles.size());
    for (std::size_t i = 0; i < bisection.triangles().size(); ++i) {
        const glm::uvec3& t = bisection.triangles()[i];
        areas[bisection.sources()[i]] +=
            0.5 * glm::length(glm::cross(positions[t.y] - positions[t.x], positions[t.z] - positions[t.x]));
    }
    for (const double sum : areas) CHECK(sum == doctest::Approx(0.5));
}

TEST_CASE("points stay where they are on the surface") {
    const Mesh mesh = make_rectangle(2);
    EdgeBisection bisection(mesh.positions, mesh.triangles);
    const auto place = [&](const WantedLength& point) {
        glm::vec3 at(0);
        for (glm::length_t k = 0; k < 3; ++k)
            at += point.weights[k] * bisection.positions()[bisection.triangles()[point.triangle][k]];
        return at;
    };
    std::vector<WantedLength> points;
    std::vector<glm::vec3> places;
    for (std::uint32_t i = 0; i < 200; ++i) {
        const float u = static_cast<float>(i % 17) / 34;
        const float v = static_cast<float>(i % 13) / 26;
        points.push_back({.triangle = i % 8, .weights = {1 - u - v, u, v}, .length = static_cast<float>(i)});
        places.push_back(place(points.back()));
    }
    split_some(bisection, 5, points);
    for (const WantedLength& point : points) {
        CHECK(std::min({point.weights.x, point.weights.y, point.weights.z}) >= 0);
        CHECK(glm::distance(place(point), places[static_cast<std::size_t>(point.length)]) < 1e-5F);
    }
}

TEST_CASE("edges with many triangles and triangles without area are split as others") {
    const Mesh mesh = fan();
    EdgeBisection bisection(mesh.positions, mesh.triangles);
    std::vector<WantedLength> points;
    const EdgeBisection::Edge shared = bisection.edge(0, 1);
    CHECK(bisection.edge(0, 5) == shared);
    EdgeBisection::Edges edges;
    edges.insert(shared);
    bisection.close(edges);
    bisection.split(edges, points);
    const std::map<EdgeBisection::Edge, int> counts = triangles_at_edges(bisection);
    CHECK(counts.count(shared) == 0);
    CHECK(counts.at(bisection.edge(0, static_cast<std::uint32_t>(mesh.positions.size()))) >= 1);
    CHECK(area(mesh_of(bisection)) == doctest::Approx(area(mesh)));
    split_some(bisection, 6, points);
    CHECK(area(mesh_of(bisection)) == doctest::Approx(area(mesh)).epsilon(1e-5));
}
