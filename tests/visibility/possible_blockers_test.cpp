// SPDX-License-Identifier: MIT
// Tests of bakes that trace no rays which nothing can block, and of bakes of some vertices.
#include "visibility/possible_blockers.hpp"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <random>
#include <string>

#include "geometry/mesh.hpp"
#include "test.hpp"
#include "visibility/refine.hpp"

using namespace nicol;

namespace {

BakeGeometry geometry_of(const Mesh& mesh) {
    return {mesh.positions, mesh.normals, mesh.triangles};
}

const DirectionSet& directions() {
    static const DirectionSet set(500);  // the last bundle is not full
    return set;
}

void append(Mesh& to, Mesh mesh, const glm::vec3& offset, float scale = 1) {
    const auto first = static_cast<std::uint32_t>(to.positions.size());
    for (const glm::vec3& p : mesh.positions) to.positions.push_back(scale * p + offset);
    to.normals.insert(to.normals.end(), mesh.normals.begin(), mesh.normals.end());
    for (const glm::uvec3& t : mesh.triangles) to.triangles.push_back(t + first);
}

/// Returns the mesh about other axes, so that no plane lies along one.
Mesh tilted(Mesh mesh) {
    const glm::dvec3 x = glm::normalize(glm::dvec3(0.3, 0.8, -0.5));
    const glm::dvec3 z = glm::normalize(glm::cross(x, glm::dvec3(0.1, 0.2, 0.9)));
    const glm::dmat3 axes(x, glm::cross(z, x), z);
    for (glm::vec3& p : mesh.positions) p = glm::vec3(axes * glm::dvec3(p));
    for (glm::vec3& n : mesh.normals) n = glm::vec3(axes * glm::dvec3(n));
    return mesh;
}

Mesh two_spheres(float apart) {
    Mesh mesh;
    append(mesh, make_sphere({}, 1, 0.3), {0, 0, 0});
    append(mesh, make_sphere({}, 1, 0.3), {apart, 0, 0});
    return mesh;
}

// Fewer vertices than those from which on neighbours spare rays.
Mesh floor_and_balls() {
    Mesh mesh;
    append(mesh, make_rectangle(36), {0, 0, 0}, 8);
    append(mesh, make_sphere({}, 1, 0.25), {0, 0, 1});
    append(mesh, make_sphere({}, 1, 0.25), {3, 1, 1.5}, 0.5);
    append(mesh, make_cube(6), {-4, 2, 0.5}, 0.4F);
    return mesh;
}

/// Returns a sphere with bumps that shadow each other.
Mesh bumpy() {
    Mesh mesh = make_sphere({}, 1, 0.5);
    for (glm::vec3& p : mesh.positions)
        p *= 1 + 0.15F * std::sin(7 * p.x) * std::sin(8 * p.y) * std::sin(9 * p.z);
    return mesh;
}

Mesh soup() {
    std::mt19937 random(5);
    std::normal_distribution<float> normal;
    Mesh mesh;
    for (std::uint32_t i = 0; i < 600; ++i) {
        const glm::vec3 centre(normal(random), normal(random), normal(random));
        for (int k = 0; k < 3; ++k)
            mesh.positions.push_back(centre +
                                     0.1F * glm::vec3(normal(random), normal(random), normal(random)));
        const glm::vec3 a = mesh.positions[3 * i];
        const glm::vec3 face =
            glm::normalize(glm::cross(mesh.positions[3 * i + 1] - a, mesh.positions[3 * i + 2] - a));
        mesh.normals.insert(mesh.normals.end(), 3, face);
        mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return mesh;
}

/// Returns both sides of a mesh, each with its own vertices.
Mesh both_sides(const Mesh& mesh) {
    Mesh out = mesh;
    Mesh back = mesh;
    for (glm::vec3& n : back.normals) n = -n;
    for (glm::uvec3& t : back.triangles) std::swap(t.y, t.z);
    append(out, back, {0, 0, 0});
    return out;
}

/// Returns a floor without the triangles of its middle, and a ball above the hole.
Mesh ball_above_hole() {
    Mesh mesh = make_rectangle(36);
    std::erase_if(mesh.triangles, [&](const glm::uvec3& t) {
        const glm::vec3 middle = (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0F;
        return std::abs(middle.x) < 0.3F && std::abs(middle.y) < 0.3F;
    });
    append(mesh, make_sphere({}, 1, 0.25), {0, 0, 0.5}, 0.3F);
    return mesh;
}

/// Returns a ball in a box that is open to one side.
Mesh ball_in_box() {
    Mesh mesh = make_cube(4);
    std::erase_if(mesh.triangles, [&](const glm::uvec3& t) { return mesh.normals[t.x].z > 0.5F; });
    append(mesh, make_sphere({}, 1, 0.25), {0.2, -0.1, 0.1}, 0.5F);
    return mesh;
}

struct Scene {
    std::string name;
    Mesh mesh;
    double most;  ///< part of all rays that may be traced
};
std::vector<Scene> scenes() {
    return {{"sphere", make_sphere(), 1e-3},
            {"tilted cube", tilted(make_cube(9)), 0.02},  // rays that graze its faces
            {"floor", make_rectangle(60), 0},
            {"tilted floor of two sides", tilted(both_sides(make_rectangle(60))), 0},
            {"two spheres far apart", two_spheres(1000), 1e-3},
            {"two spheres", two_spheres(4), 0.1},
            {"balls on a floor", tilted(floor_and_balls()), 0.25},
            {"balls on a level floor", floor_and_balls(), 0.25},
            {"a ball above a hole", tilted(ball_above_hole()), 1},
            {"a ball above a hole in a level floor", ball_above_hole(), 1},
            {"a ball in a box", tilted(ball_in_box()), 0.3},
            {"a ball in an upright box", ball_in_box(), 0.3},
            {"bumps", bumpy(), 1},
            {"soup", both_sides(soup()), 1}};
}

bool equal(const Visibility& a, const Visibility& b) {
    return std::ranges::equal(a.bits(), b.bits()) && std::ranges::equal(a.unoccluded(), b.unoccluded());
}

}  // namespace

TEST_CASE("rays that nothing can block are skipped, and visibility is that of all rays") {
    for (const Scene& scene : scenes()) {
        CAPTURE(scene.name);
        BakeGeometry geometry = geometry_of(scene.mesh);
        BakeStatistics some, all;
        const Visibility skipping = bake(geometry, directions(), {}, &some);
        geometry.every_ray = true;
        const Visibility tracing = bake(geometry, directions(), {}, &all);
        CHECK(equal(skipping, tracing));
        CHECK(all.rays_skipped == 0);
        CHECK(static_cast<double>(some.rays) <= scene.most * static_cast<double>(all.rays));
        CHECK(some.vertices == all.vertices);
        // A few rays are so low that they are never traced.
        const double together = static_cast<double>(some.rays + some.rays_skipped);
        CHECK(together >= static_cast<double>(all.rays));
        CHECK((scene.most == 1 || together <= 1.001 * static_cast<double>(all.rays)));
    }
}

TEST_CASE("refinement is that of all rays") {
    const Mesh mesh = tilted(floor_and_balls());
    BakeGeometry geometry = geometry_of(mesh);
    BakeStatistics some, all;
    const RefineOptions options{.tolerance = 0.02, .max_vertices = 20000};
    const Visibility visibility = bake(geometry, directions());
    const Refinement skipping = refine(geometry, directions(), visibility, options, {}, some);
    geometry.every_ray = true;
    const Refinement tracing = refine(geometry, directions(), visibility, options, {}, all);
    CHECK(skipping.parents.size() > 100);
    CHECK(skipping.parents == tracing.parents);
    CHECK(skipping.triangles == tracing.triangles);
    CHECK(equal(skipping.visibility, tracing.visibility));
    CHECK(some.rays < all.rays);
    CHECK(some.rays_skipped > 0);
}

TEST_CASE("vertices that are not needed count as unoccluded, and triangles at them stay whole") {
    const Mesh mesh = floor_and_balls();
    BakeGeometry geometry = geometry_of(mesh);
    const Visibility all = bake(geometry, directions());
    // All objects, and the floor but for the part under the cube.
    std::vector<std::uint8_t> needed;
    for (const glm::vec3& p : mesh.positions) needed.push_back(p.z > 0.01F || p.x > -2.5F ? 1 : 0);
    geometry.needed = needed;
    BakeStatistics baked;
    const Visibility part = bake(geometry, directions(), {}, &baked);
    for (std::size_t v = 0; v < needed.size(); ++v) {
        if (needed[v] != 0) {
            CHECK(std::ranges::equal(part.at(v), all.at(v)));
            CHECK(part.unoccluded(v) == all.unoccluded(v));
            continue;
        }
        CHECK(part.unoccluded(v));
        for (std::size_t d = 0; d < directions().size(); ++d)
            CHECK(part.seen(v, d) == (glm::dot(mesh.normals[v], directions().directions()[d]) > 0));
    }
    const RefineOptions options{.tolerance = 0.02, .max_vertices = 20000};
    const Refinement refined = refine(geometry, directions(), part, options, {}, baked);
    REQUIRE(!refined.parents.empty());
    std::size_t beyond = 0;
    for (const glm::uvec2& pair : refined.parents)
        for (const std::uint32_t v : {pair.x, pair.y}) beyond += v < needed.size() && needed[v] == 0 ? 1 : 0;
    // Neighbours of divided triangles are divided as well.
    CHECK(beyond < refined.parents.size() / 20);
}
