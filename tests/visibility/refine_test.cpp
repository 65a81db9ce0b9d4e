// SPDX-License-Identifier: MIT
// Tests of vertices added where shadows change.
#include "visibility/refine.hpp"

#include <bit>

#include "geometry/mesh.hpp"
#include "test.hpp"
#include "visibility/point_tracer.hpp"

using namespace nicol;

namespace {

void append(Mesh& to, const Mesh& mesh, float scale, const glm::vec3& offset) {
    const auto first = static_cast<std::uint32_t>(to.positions.size());
    for (const glm::vec3& p : mesh.positions) to.positions.push_back(scale * p + offset);
    to.normals.insert(to.normals.end(), mesh.normals.begin(), mesh.normals.end());
    for (const glm::uvec3& t : mesh.triangles) to.triangles.push_back(t + first);
}

/// Returns a floor of two triangles of half width `half`, and a cube of half width 0.2 standing on it away
/// from all edges of the floor.
Mesh cube_on_floor(float half) {
    Mesh mesh;
    append(mesh, make_rectangle(1), half, {0, 0, 0});
    append(mesh, make_cube(2), 0.2F, {0.4512F, -0.4031F, 0.2F});
    return mesh;
}

const DirectionSet& directions() {
    static const DirectionSet set(512);
    return set;
}

BakeGeometry geometry_of(const Mesh& mesh) {
    return {mesh.positions, mesh.normals, mesh.triangles};
}

struct Refined {
    Visibility baked;
    Refinement refinement;
    BakeStatistics statistics;
};

Refined refine(const Mesh& mesh, const RefineOptions& options) {
    Refined out;
    out.baked = bake(geometry_of(mesh), directions(), {}, &out.statistics);
    out.refinement = refine(geometry_of(mesh), directions(), out.baked, options, {}, out.statistics);
    return out;
}

/// Returns the visible cosine-weighted part of the hemisphere about +z.
double seen_from(const Visibility& visibility, std::size_t vertex) {
    double sum = 0;
    for (std::size_t i = 0; i < directions().size(); ++i) {
        if (visibility.seen(vertex, i))
            sum += static_cast<double>(directions().weights()[i] * directions().directions()[i].z) / pi;
    }
    return sum;
}

struct Surface {
    std::vector<glm::vec3> positions;
    const Refinement& refinement;

    Surface(const Mesh& mesh, const Refinement& from) : positions(mesh.positions), refinement(from) {
        for (const glm::uvec2& p : from.parents)
            positions.push_back(0.5F * positions[p.x] + 0.5F * positions[p.y]);
    }

    /// Returns the interpolated visible part at a point of the floor.
    double seen(double x, double y) const {
        for (std::size_t i = 0; i < refinement.triangles.size(); ++i) {
            if (refinement.sources[i] > 1) break;
            const glm::uvec3& t = refinement.triangles[i];
            const glm::dvec2 a(positions[t.x]);
            const glm::dvec2 u = glm::dvec2(positions[t.y]) - a;
            const glm::dvec2 v = glm::dvec2(positions[t.z]) - a;
            const glm::dvec2 p = glm::dvec2(x, y) - a;
            const double whole = u.x * v.y - u.y * v.x;
            const double b = (p.x * v.y - p.y * v.x) / whole;
            const double c = (u.x * p.y - u.y * p.x) / whole;
            if (b < -1e-6 || c < -1e-6 || b + c > 1 + 1e-6) continue;
            return (1 - b - c) * seen_from(refinement.visibility, t.x) +
                   b * seen_from(refinement.visibility, t.y) + c * seen_from(refinement.visibility, t.z);
        }
        FAIL("no triangle there");
        return 0;
    }
};

}  // namespace

TEST_CASE("interpolation meets what rays find between vertices, on floors of any size") {
    for (const float half : {1.0F, 30.0F}) {
        const Mesh mesh = cube_on_floor(half);
        const Refined refined = refine(mesh, {.tolerance = 0.02, .max_vertices = 20000});
        const Surface surface(mesh, refined.refinement);
        CAPTURES(half, surface.positions.size());
        CHECK(surface.positions.size() < 4000);
        // Probes lie beside the cube on a floor that is finely divided there.
        Mesh probes = mesh;
        constexpr int across = 12;
        append(probes, make_rectangle(across), 0.5F, {0.4512F, -0.4031F, 0});
        const Visibility truth = bake(geometry_of(probes), directions());
        double sum = 0;
        int count = 0;
        for (std::size_t v = mesh.positions.size(); v < probes.positions.size(); ++v) {
            const glm::vec3 p = probes.positions[v];
            if (std::max(std::abs(p.x - 0.4512F), std::abs(p.y + 0.4031F)) < 0.22F) continue;
            const double error =
                surface.seen(static_cast<double>(p.x), static_cast<double>(p.y)) - seen_from(truth, v);
            sum += error * error;
            ++count;
        }
        CHECK(count > 100);
        CHECK(std::sqrt(sum / count) < 0.02);
    }
}

TEST_CASE("errors are small beside the light that is left, under a low roof") {
    Mesh mesh;
    append(mesh, make_rectangle(1), 1, {0, 0, 0});
    append(mesh, make_rectangle(1), 1, {0, 0, 0.5F});
    const Refined refined = refine(mesh, {.tolerance = 0.02, .max_vertices = 20000});
    const Surface surface(mesh, refined.refinement);
    Mesh probes = mesh;
    append(probes, make_rectangle(16), 0.95F, {0, 0, 0});
    const Visibility truth = bake(geometry_of(probes), directions());
    double sum = 0;
    double power = 0;
    for (std::size_t v = mesh.positions.size(); v < probes.positions.size(); ++v) {
        const glm::vec3 p = probes.positions[v];
        const double seen = seen_from(truth, v);
        const double error = surface.seen(static_cast<double>(p.x), static_cast<double>(p.y)) - seen;
        sum += error * error;
        power += seen * seen;
    }
    CAPTURES(surface.positions.size(), std::sqrt(power));
    CHECK(std::sqrt(sum / power) < 0.015);
}

TEST_CASE("added vertices see what a bake of the refined mesh finds") {
    const Mesh mesh = cube_on_floor(1);
    const Refined refined = refine(mesh, {.tolerance = 0.03, .max_vertices = 20000});
    const Surface surface(mesh, refined.refinement);
    const Mesh fine{.positions = surface.positions,
                    .normals =
                        [&] {
                            std::vector<glm::vec3> normals = mesh.normals;
                            for (const glm::uvec2& p : refined.refinement.parents)
                                normals.push_back(0.5F * normals[p.x] + 0.5F * normals[p.y]);
                            return normals;
                        }(),
                    .triangles = refined.refinement.triangles};
    const Visibility baked = bake(geometry_of(fine), directions());
    REQUIRE(baked.vertices() == refined.refinement.visibility.vertices());
    std::size_t differing = 0;
    std::size_t bits = 0;
    for (std::size_t v = 0; v < baked.vertices(); ++v) {
        for (std::size_t i = 0; i < directions().size(); ++i) {
            differing += baked.seen(v, i) != refined.refinement.visibility.seen(v, i) ? 1 : 0;
            bits += baked.seen(v, i) ? 1 : 0;
        }
    }
    // Rounding moves the start of rays beside their vertices, in different directions.
    CHECK(static_cast<double>(differing) < 2e-3 * static_cast<double>(bits));
}

TEST_CASE("vertices are bounded, counted and the same every time") {
    const Mesh mesh = cube_on_floor(1);
    const std::size_t given = mesh.positions.size();
    std::size_t last = 0;
    for (const std::size_t most : {given, given + 1, given + 20, given + 200, given + 20000}) {
        const Refined refined = refine(mesh, {.tolerance = 0.02, .max_vertices = most});
        const std::size_t added = refined.refinement.parents.size();
        CAPTURES(most, added);
        CHECK(given + added <= most);
        CHECK(added >= last);
        CHECK((added > 0) == (most > given));
        last = added;
        CHECK(refined.statistics.vertices >= given + added);
        const Refined again = refine(mesh, {.tolerance = 0.02, .max_vertices = most});
        CHECK(again.refinement.triangles == refined.refinement.triangles);
        CHECK(std::ranges::equal(again.refinement.visibility.bits(), refined.refinement.visibility.bits()));
    }
    CHECK(last > 200);
    CHECK(refine(mesh, {.tolerance = 1, .max_vertices = 20000}).refinement.parents.size() < last);
}

TEST_CASE("nothing is added where nothing is hidden, and no ray is traced") {
    const Refined refined = refine(make_cube(3), {.tolerance = 1e-3, .max_vertices = 20000});
    CHECK(refined.refinement.parents.empty());
    CHECK(refined.statistics.vertices == refined.baked.vertices());
}

TEST_CASE("any triangles come to an end") {
    // The mesh has many triangles at one edge, slivers, triangles without extent, coincident vertices, and
    // distant and tiny parts.
    Mesh bad = cube_on_floor(1e3F);
    append(bad, make_rectangle(1), 1e-6F, {0, 0, 1e-6F});
    append(bad, make_rectangle(1), 1, {0, 0, 0});
    bad.positions.insert(bad.positions.end(), {{0, 0, 0.1F}, {1, 0, 0.1F}, {1, 1e-6F, 0.1F}});
    bad.normals.insert(bad.normals.end(), {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}});
    const auto last = static_cast<std::uint32_t>(bad.positions.size());
    bad.triangles.insert(
        bad.triangles.end(),
        {{last - 3, last - 2, last - 1}, {0, 1, last - 1}, {0, 1, last - 2}, {2, 2, 3}, {1, 1, 1}});
    const Refined refined = refine(bad, {.tolerance = 1e-4, .max_vertices = 3000});
    CHECK(refined.refinement.visibility.vertices() <= 3000);
    CHECK(refined.refinement.visibility.vertices() > 1000);
}

TEST_CASE("a refinement from the points of a former one equals a new one, with fewer rays") {
    const auto scene = [](const std::vector<glm::vec3>& cubes) {
        Mesh mesh;
        append(mesh, make_rectangle(1), 3, {0, 0, 0});
        for (const glm::vec3& place : cubes) append(mesh, make_cube(2), 0.2F, place);
        return mesh;
    };
    const auto around = [](const glm::vec3& place) { return Ball{.centre = place, .radius = 0.35F}; };
    const RefineOptions options{.tolerance = 0.02, .max_vertices = 20000};
    std::mt19937 random(3);
    std::uniform_real_distribution<float> coordinate(-2, 2);
    std::vector<glm::vec3> cubes{{1.1F, 0.3F, 0.2F}, {-1.3F, 0.4F, 0.2F}, {0.2F, -1.2F, 0.2F}};
    TracedPoints points = refine(scene(cubes), options).refinement.points;
    for (int edit = 0; edit < 12; ++edit) {
        std::vector<Ball> added, removed;
        const std::size_t cube = random() % cubes.size();
        if (edit % 3 != 1) {
            removed.push_back(around(cubes[cube]));
            cubes.erase(cubes.begin() + static_cast<std::ptrdiff_t>(cube));
        }
        if (edit % 3 != 2) {
            cubes.emplace_back(coordinate(random), coordinate(random), 0.21F);
            added.push_back(around(cubes.back()));
        }
        const Mesh mesh = scene(cubes);
        const Refined fresh = refine(mesh, options);
        const FormerRefinement former{.points = points, .disturbances = {added, removed}};
        BakeStatistics statistics;
        Refinement next =
            refine(geometry_of(mesh), directions(), fresh.baked, options, {}, statistics, &former);
        CAPTURES(edit, cubes.size());
        REQUIRE(next.parents == fresh.refinement.parents);
        CHECK(next.triangles == fresh.refinement.triangles);
        CHECK(std::ranges::equal(next.visibility.bits(), fresh.refinement.visibility.bits()));
        const std::uint64_t all = fresh.statistics.rays + fresh.statistics.rays_skipped;
        CHECK(statistics.rays < (all - fresh.baked.vertices() * 100) / 2);
        points = std::move(next.points);
    }
}

TEST_CASE("only triangles at wanted vertices are split") {
    const Mesh mesh = cube_on_floor(1);
    const std::size_t of_floor = make_rectangle(1).positions.size();
    std::vector<std::uint8_t> wanted(mesh.positions.size(), 1);
    std::fill_n(wanted.begin(), of_floor, std::uint8_t{0});
    RefineOptions options{.tolerance = 0.005, .max_vertices = 20000};
    const auto of_floor_split = [](const Refined& refined) {
        return std::ranges::count_if(refined.refinement.sources, [](std::uint32_t t) { return t < 2; }) > 2;
    };
    CHECK(of_floor_split(refine(mesh, options)));
    options.wanted = wanted;
    const Refined refined = refine(mesh, options);
    CHECK_FALSE(refined.refinement.parents.empty());
    CHECK_FALSE(of_floor_split(refined));
}

TEST_CASE("progress grows from 0 to 1 while points are traced") {
    const Mesh mesh = cube_on_floor(1);
    BakeStatistics statistics;
    std::vector<double> fractions;
    const Refinement refinement = refine(
        geometry_of(mesh), directions(), bake(geometry_of(mesh), directions()),
        {.tolerance = 0.002, .max_vertices = 60000}, [&](double done) { fractions.push_back(done); },
        statistics);
    REQUIRE(refinement.points.size() > 8192);
    CHECK(std::ranges::is_sorted(fractions));
    CHECK(fractions.front() < 0.5);
    CHECK(fractions.back() > 0.75);
    CHECK(fractions.back() <= 1);
}

TEST_CASE("rays on which both ends agree are spared, unless the sample disagrees") {
    const Mesh mesh = cube_on_floor(1);
    BakeGeometry geometry = geometry_of(mesh);
    geometry.every_ray = true;
    const PointTracer tracer(geometry, directions(), nullptr);
    const glm::vec3 up(0, 0, 1);
    const auto traced = [&](float x, std::span<const Seeing> ends, Visibility& seen) {
        glm::vec4 hides;
        seen = Visibility(directions().size(), 1);
        return tracer.trace({.origin = {x, -0.4F, 1e-4F}, .normal = up, .given = 0}, ends, 0, seen, hides)
            .traced;
    };
    Visibility left, right, all, some, doubted, open;
    traced(0.2F, {}, left);
    traced(0.21F, {}, right);
    const std::uint64_t whole = traced(0.205F, {}, all);
    const std::array<Seeing, 2> ends{{{left.at(0), up}, {right.at(0), up}}};
    const std::uint64_t few = traced(0.205F, ends, some);
    CAPTURES(whole, few);
    CHECK(2 * few < whole);
    int wrong = 0;
    for (std::size_t w = 0; w < all.at(0).size(); ++w) wrong += std::popcount(all.at(0)[w] ^ some.at(0)[w]);
    CHECK(wrong <= 2);

    // Far from the cube, hardly anything of it is seen, but the ends say nothing of the middle.
    traced(-0.9F, {}, open);
    const std::array<Seeing, 2> far{{{open.at(0), up}, {open.at(0), up}}};
    CHECK(traced(0.205F, far, doubted) >= whole);
    CHECK(std::ranges::equal(doubted.at(0), all.at(0)));
}

TEST_CASE("short edges are refined to what all rays find") {
    const Mesh mesh = cube_on_floor(1);
    const Visibility baked = bake(geometry_of(mesh), directions());
    const RefineOptions options{.tolerance = 0.005, .max_vertices = 60000, .shortest_edge = 0.02};
    BakeGeometry geometry = geometry_of(mesh);
    BakeStatistics some, all;
    const Refinement sparing = refine(geometry, directions(), baked, options, {}, some);
    geometry.every_ray = true;
    const Refinement tracing = refine(geometry, directions(), baked, options, {}, all);
    CHECK(some.rays < all.rays);
    const Surface spared(mesh, sparing), traced(mesh, tracing);
    double most = 0;
    for (double x = 0.15; x < 0.8; x += 0.033)
        for (double y = -0.7; y < -0.1; y += 0.033)
            most = std::max(most, std::abs(spared.seen(x, y) - traced.seen(x, y)));
    CAPTURE(most);
    CHECK(most < 0.02);
}
