// SPDX-License-Identifier: MIT
// Tests of bakes of fine surfaces, whose vertices spare rays that their neighbours agree on.
#include "visibility/agreeing_neighbours.hpp"

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <random>
#include <string>
#include <utility>

#include "geometry/mesh.hpp"
#include "test.hpp"
#include "visibility/bake.hpp"
#include "visibility/points_in_pixels.hpp"
#include "visibility/ray_cones.hpp"

using namespace nicol;

namespace {

const DirectionSet& directions() {
    static const DirectionSet set(500);  // the last bundle is not full
    return set;
}

Mesh with_smooth_normals(Mesh mesh) {
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0));
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::vec3 normal =
            glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
        for (glm::length_t k = 0; k < 3; ++k) mesh.normals[t[k]] += normal;
    }
    return mesh;
}

Mesh cloth() {
    Mesh mesh = make_rectangle(90);
    for (glm::vec3& p : mesh.positions)
        p = 3.0F * p + glm::vec3(0, 0, 0.3F * std::sin(15 * p.x + 2 * std::sin(9 * p.y)));
    return with_smooth_normals(std::move(mesh));
}

/// Returns a floor whose vertices lie higher or lower by chance.
Mesh rough_floor() {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> height(0, 0.05F);
    Mesh mesh = make_rectangle(70);
    for (glm::vec3& p : mesh.positions) p.z += height(random);
    return with_smooth_normals(std::move(mesh));
}

/// Returns a floor that a small ball touches.
Mesh touched_floor() {
    Mesh mesh = make_rectangle(90);
    const Mesh ball = make_sphere({0, 0, 0.05}, 0.05, 0.2);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), ball.positions.begin(), ball.positions.end());
    mesh.normals.insert(mesh.normals.end(), ball.normals.begin(), ball.normals.end());
    for (const glm::uvec3& t : ball.triangles) mesh.triangles.push_back(t + first);
    return mesh;
}

/// Returns the triangles each with vertices of their own.
Mesh taken_apart(const Mesh& mesh) {
    Mesh out;
    for (const glm::uvec3& t : mesh.triangles) {
        const auto first = static_cast<std::uint32_t>(out.positions.size());
        out.triangles.emplace_back(first, first + 1, first + 2);
        for (glm::length_t k = 0; k < 3; ++k) {
            out.positions.push_back(mesh.positions[t[k]]);
            out.normals.push_back(mesh.normals[t[k]]);
        }
    }
    return out;
}

/// Returns many triangles around one vertex, in the plane z = 0 but for the first vertices.
Mesh fan() {
    Mesh mesh;
    mesh.positions.emplace_back(0, 0, 0);
    constexpr std::uint32_t count = 20000;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double angle = 2 * 3.14159265358979 * i / count;
        mesh.positions.emplace_back(std::cos(angle), std::sin(angle), i < 100 ? 0.5 : 0);
        mesh.triangles.emplace_back(0, 1 + i, 1 + (i + 1) % count);
    }
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0, 0, 1));
    return mesh;
}

/// Returns the part of an even sky's light that reaches a vertex.
double light_at(const Mesh& mesh, const Visibility& visibility, std::size_t vertex) {
    double seen = 0, all = 0;
    for (std::size_t i = 0; i < directions().size(); ++i) {
        const double cosine = glm::dot(glm::normalize(mesh.normals[vertex]), directions().directions()[i]);
        if (!(cosine > 0)) continue;
        all += cosine;
        if (visibility.seen(vertex, i)) seen += cosine;
    }
    return seen / all;
}

/// Returns the RMS over the vertices of the difference in that part.
double rms_off(const Mesh& mesh, const Visibility& a, const Visibility& b) {
    double sum = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const double off = light_at(mesh, a, v) - light_at(mesh, b, v);
        sum += off * off;
    }
    return std::sqrt(sum / static_cast<double>(mesh.positions.size()));
}

/// Returns BakeGeometry::like for pixels of this side.
std::vector<std::uint32_t> in_pixels(const Mesh& mesh, double pixel) {
    PointsInPixels cells(pixel);
    std::vector<std::uint32_t> like;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
        const std::uint32_t first = cells.add(mesh.positions[v], glm::normalize(mesh.normals[v]), v);
        like.push_back(first == v ? kNoVertex : first);
    }
    return like;
}

}  // namespace

TEST_CASE("rays that neighbours agree on are spared, and the light at vertices stays") {
    struct Case {
        std::string name;
        Mesh mesh;
        double most;  // of all rays, the part that may be traced
    };
    const Case cases[] = {{"cloth", cloth(), 0.55},
                          {"cloth whose triangles share no vertices", taken_apart(cloth()), 0.55},
                          {"floor with details between vertices", rough_floor(), 0.9},
                          {"floor that a ball touches", touched_floor(), 0.15},
                          {"very many triangles at a vertex", fan(), 0.3}};
    for (const Case& each : cases) {
        CAPTURE(each.name);
        BakeGeometry geometry{each.mesh.positions, each.mesh.normals, each.mesh.triangles};
        BakeStatistics some, all;
        const Visibility spared = bake(geometry, directions(), {}, &some);
        geometry.every_ray = true;
        const Visibility traced = bake(geometry, directions(), {}, &all);
        CHECK(static_cast<double>(some.rays) <= each.most * static_cast<double>(all.rays));
        CHECK(rms_off(each.mesh, spared, traced) <= 0.01);
        double worst = 0;
        for (std::size_t v = 0; v < each.mesh.positions.size(); ++v)
            worst =
                std::max(worst, std::abs(light_at(each.mesh, spared, v) - light_at(each.mesh, traced, v)));
        CHECK(worst <= 0.14);
    }
}

TEST_CASE("vertices in a pixel trace the rays of one, and the light at vertices stays") {
    struct Case {
        std::string name;
        Mesh mesh;
        double most;  // of all rays, the part that may be traced
    };
    for (const Case& each : {Case{"cloth", cloth(), 0.5},
                             {"cloth whose triangles share no vertices", taken_apart(cloth()), 0.2},
                             {"floor with details below a pixel", rough_floor(), 0.85},
                             {"floor that a ball touches", touched_floor(), 0.08}}) {
        CAPTURE(each.name);
        const std::vector<std::uint32_t> like = in_pixels(each.mesh, 0.08);
        BakeGeometry geometry{each.mesh.positions, each.mesh.normals, each.mesh.triangles};
        geometry.like = like;
        BakeStatistics some, all;
        const Visibility shared = bake(geometry, directions(), {}, &some);
        geometry.every_ray = true;
        const Visibility traced = bake(geometry, directions(), {}, &all);
        CHECK(static_cast<double>(some.rays) <= each.most * static_cast<double>(all.rays));
        CHECK(rms_off(each.mesh, shared, traced) <= 0.02);
    }
}

TEST_CASE("rays beside one that differs are traced, and all if many differ") {
    const glm::vec3 up(0, 0, 1);
    const RayCones cones(directions());
    Visibility open(directions().size(), 1);
    const std::uint64_t all = set_open(directions(), up, 0, open);
    const std::vector<Seeing> around(3, {.bits = open.at(0), .normal = up});
    std::mt19937 random(5);
    struct Case {
        std::string name;
        std::function<bool(const glm::vec3& direction)> blocked;
        double least, most;  // of all rays, the part that is traced
    };
    const glm::vec3 middle = glm::normalize(glm::vec3(0.3, 0.5, 1));
    for (const Case& each :
         {Case{"nothing", [](const glm::vec3&) { return false; }, 0.05, 0.15},
          {"a patch", [&](const glm::vec3& d) { return glm::dot(d, middle) > 0.97F; }, 0.1, 0.3},
          {"every second ray", [&](const glm::vec3&) { return random() % 2 == 0; }, 1, 1}}) {
        CAPTURE(each.name);
        std::vector<std::uint64_t> truth(open.at(0).begin(), open.at(0).end());
        for (std::size_t i = 0; i < directions().size(); ++i)
            if (each.blocked(directions().directions()[i])) truth[i / 64] &= ~(std::uint64_t{1} << i % 64);
        Agreement agreement;
        agreement.find(around, 3, directions(), up, 0);
        std::vector<std::uint64_t> row(truth.size(), 0);
        const RayCounts counts = agreement.settle(row, cones, [&](const FormerBits& known) {
            RayCounts traced;
            for (std::size_t i = 0; i < directions().size(); ++i) {
                const std::uint64_t bit = std::uint64_t{1} << i % 64;
                const bool asked = (known.disturbed->may_close[i / 16] >> i % 16 & 1) != 0;
                row[i / 64] |= (asked ? truth[i / 64] : known.bits[i / 64]) & bit;
                if (asked && (open.at(0)[i / 64] & bit) != 0) ++traced.traced;
            }
            return traced;
        });
        CHECK(row == truth);
        CHECK(counts.traced + counts.skipped == all);
        CHECK(static_cast<double>(counts.traced) >= each.least * static_cast<double>(all));
        CHECK(static_cast<double>(counts.traced) <= each.most * static_cast<double>(all));
    }
}

TEST_CASE("each needed vertex has one turn") {
    const Mesh mesh = cloth();
    const std::vector<std::uint32_t> like = in_pixels(mesh, 0.08);
    std::vector<std::uint8_t> needed;
    for (const glm::vec3& p : mesh.positions) needed.push_back(p.x > 0 ? 1 : 0);
    std::vector<glm::vec3> normals;
    for (const glm::vec3& n : mesh.normals) normals.push_back(glm::normalize(n));
    for (const auto& [find, shares] : {std::pair(true, false), {false, false}, {true, true}, {false, true}}) {
        BakeGeometry geometry{
            .positions = mesh.positions, .normals = normals, .triangles = mesh.triangles, .needed = needed};
        if (shares) geometry.like = like;
        const AgreeingNeighbours agreeing(geometry, normals, find);
        std::vector<std::uint8_t> found(needed.size(), 0);
        for (const std::vector<std::uint32_t>& turn : agreeing.turns())
            for (const std::uint32_t v : turn) ++found[v];
        CHECK(found == needed);
        CHECK(agreeing.turns().size() == (find ? 3 : 1) + (shares ? 1 : 0));
    }
}
