// SPDX-License-Identifier: MIT
#include "surfaces/given_origins.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "geometry/largest_coordinate.hpp"
#include "geometry/unit.hpp"
#include "visibility/bake_origins.hpp"

namespace nicol {
namespace {

// Number of balls from which on all origins are found anew.
constexpr std::size_t kManyBalls = 64;

// Returns whether a point lies in a ball, or so close to it that rounding may decide.
bool touches(std::span<const Ball> balls, const glm::vec3& point) {
    constexpr float slack = 1.001F;
    return std::ranges::any_of(balls, [&](const Ball& ball) {
        const glm::vec3 to = point - ball.centre;
        const float reach = slack * ball.radius + 1e-6F * largest_coordinate(ball.centre);
        return glm::dot(to, to) <= reach * reach;
    });
}

std::vector<glm::vec3> origins_of(const BakeGeometry& geometry) {
    std::vector<glm::vec3> normals;
    normals.reserve(geometry.normals.size());
    for (const glm::vec3& normal : geometry.normals) normals.push_back(unit(normal));
    return bake_origins(geometry, normals);
}

// Sets the origins of the vertices with stale[v] != 0. A vertex at the position of a stale one must be stale.
void renew(const WorldGeometry& geometry, std::span<const std::uint8_t> stale, std::span<glm::vec3> origins) {
    // The part of the geometry that stale origins depend on: all triangles with stale corners.
    std::vector<std::uint32_t> index(stale.size(), kNoVertex), vertices;
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::uvec3> triangles;
    const auto index_of = [&](std::uint32_t v) {
        if (index[v] == kNoVertex) {
            index[v] = static_cast<std::uint32_t>(vertices.size());
            vertices.push_back(v);
            positions.push_back(geometry.positions[v]);
            normals.push_back(geometry.normals[v]);
        }
        return index[v];
    };
    for (const glm::uvec3& t : geometry.triangles)
        if ((stale[t.x] | stale[t.y] | stale[t.z]) != 0)
            triangles.emplace_back(index_of(t.x), index_of(t.y), index_of(t.z));
    for (std::uint32_t v = 0; v < stale.size(); ++v)
        if (stale[v] != 0) index_of(v);
    const std::vector<glm::vec3> renewed =
        origins_of({.positions = positions, .normals = normals, .triangles = triangles});
    for (std::size_t i = 0; i < vertices.size(); ++i)
        if (stale[vertices[i]] != 0) origins[vertices[i]] = renewed[i];
}

}  // namespace

const std::vector<glm::vec3>& GivenOrigins::of(const SceneGeometry& surfaces) {
    if (version_ == surfaces.version()) return origins_;
    const SceneGeometry::Change& change = surfaces.change();
    const bool follows = version_ != 0 && version_ == change.before &&
                         change.added.size() + change.removed.size() <= kManyBalls;
    version_ = 0;
    if (follows) {
        carry(surfaces);
    } else {
        const WorldGeometry& geometry = surfaces.geometry();
        origins_ = origins_of(
            {.positions = geometry.positions, .normals = geometry.normals, .triangles = geometry.triangles});
    }
    version_ = surfaces.version();
    return origins_;
}

void GivenOrigins::carry(const SceneGeometry& surfaces) {
    const SceneGeometry::Change& change = surfaces.change();
    const WorldGeometry& geometry = surfaces.geometry();
    std::vector<glm::vec3> next(geometry.positions.size());
    std::vector<std::uint8_t> stale(next.size(), 1);
    for (const VertexRun& run : change.kept) {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(run.first, run.last, 4096), [&](const auto& some) {
            for (std::size_t v = some.begin(); v < some.end(); ++v) {
                // Vertices at one position depend on each other, so a vertex that has not moved may depend on
                // one that has.
                const glm::vec3& at = geometry.positions[v];
                const bool beside = touches(change.added, at) || touches(change.removed, at);
                next[v] = origins_[run.before + (v - run.first)];
                stale[v] = beside ? 1 : 0;
            }
        });
    }
    renew(geometry, stale, next);
    origins_ = std::move(next);
}

}  // namespace nicol
