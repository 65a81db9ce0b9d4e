// SPDX-License-Identifier: MIT
// Tests of the environment that vertices see past the triangles of the scene.
#include "visibility/bake.hpp"

#include <tbb/task_arena.h>

#include <complex>
#include <thread>

#include "geometry/mesh.hpp"
#include "harmonics/evaluate.hpp"
#include "harmonics/psh.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

BakeGeometry geometry_of(const Mesh& mesh) {
    return {mesh.positions, mesh.normals, mesh.triangles};
}

const DirectionSet& few() {
    static const DirectionSet set(256);
    return set;
}

// Returns a cone of height 2 with its tip up. The normal at the tip is the axis, or that of each face.
Mesh make_cone(bool shared_tip) {
    constexpr int sides = 24;
    Mesh mesh;
    const auto rim = [](int i) {
        const double phi = 2 * pi * i / sides;
        return glm::vec3(std::cos(phi), std::sin(phi), 0);
    };
    for (int i = 0; i < sides; ++i) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), {rim(i), rim(i + 1), {0, 0, 2}, {0, 0, 0}});
        mesh.triangles.emplace_back(first, first + 1, first + 2);
        mesh.triangles.emplace_back(first + 1, first, first + 3);
        const glm::vec3 face = glm::normalize(glm::cross(rim(i + 1) - rim(i), glm::vec3(0, 0, 2) - rim(i)));
        mesh.normals.insert(mesh.normals.end(),
                            {face, face, shared_tip ? glm::vec3(0, 0, 1) : face, {0, 0, -1}});
    }
    return mesh;
}

Mesh placed(Mesh mesh, double scale, const glm::dvec3& offset) {
    for (glm::vec3& p : mesh.positions) p = glm::vec3(scale * (glm::dvec3(p) + offset));
    return mesh;
}

void append(Mesh& to, const Mesh& mesh) {
    const auto first = static_cast<std::uint32_t>(to.positions.size());
    to.positions.insert(to.positions.end(), mesh.positions.begin(), mesh.positions.end());
    to.normals.insert(to.normals.end(), mesh.normals.begin(), mesh.normals.end());
    for (const glm::uvec3& t : mesh.triangles) to.triangles.push_back(t + first);
}

// Returns one vertex at the origin that faces up, with a tiny triangle to hold it.
Mesh lookout() {
    return {.positions = {{0, 0, 0}, {0.01F, 0, 0}, {0, 0.01F, 0}},
            .normals = std::vector<glm::vec3>(3, {0, 0, 1}),
            .triangles = {{0, 1, 2}}};
}

bool none_seen(const Visibility& visibility, std::size_t vertex) {
    return std::ranges::all_of(visibility.at(vertex), [](std::uint64_t word) { return word == 0; });
}

}  // namespace

TEST_CASE("a closed convex surface never shadows itself, whatever its size and place") {
    Mesh smooth_cube = make_cube(1);
    for (std::size_t v = 0; v < smooth_cube.positions.size(); ++v) {
        smooth_cube.normals[v] = glm::normalize(smooth_cube.positions[v]);
    }
    const Mesh sphere = make_sphere();
    const Mesh shapes[] = {make_cube(5), smooth_cube, make_cone(true), make_cone(false)};
    const auto check = [](const Mesh& mesh) {
        BakeStatistics statistics;
        const Visibility visibility = bake(geometry_of(mesh), few(), {}, &statistics);
        CHECK(statistics.unoccluded == mesh.positions.size());
        CHECK(visibility.unoccluded_count() == mesh.positions.size());
    };
    for_all({1e-6, 1e-3, 1.0, 37.0, 1e6},
            {glm::dvec3(0), glm::dvec3(3, -7, 11), glm::dvec3(1000, 300, -2000)},
            [&](double scale, const glm::dvec3& offset) {
                CAPTURES(scale, offset.x);
                for (const Mesh& mesh : shapes) check(placed(mesh, scale, offset));
            });
    for (const auto& [scale, offset] : {std::pair{1e-6, 0.0}, std::pair{1e6, 0.0}, std::pair{1.0, 100.0}}) {
        CAPTURE(scale);
        check(placed(sphere, scale, glm::dvec3(offset, -offset, 2 * offset)));
    }
    check(with_face_normals(make_sphere({2, 3, 4}, 5)));
}

TEST_CASE("directions above the horizon are seen, the others not") {
    const Mesh cube = make_cube(2);
    const DirectionSet set(1000);
    BakeStatistics statistics;
    const Visibility visibility = bake(geometry_of(cube), set, {}, &statistics);
    std::uint64_t above = 0;
    for (std::size_t v = 0; v < cube.positions.size(); ++v) {
        for (std::size_t i = 0; i < set.size(); ++i) {
            const float height = glm::dot(cube.normals[v], set.directions()[i]);
            if (std::abs(height) < 1e-4F) continue;
            CHECK(visibility.seen(v, i) == (height > 0));
            above += height > 0 ? 1 : 0;
        }
    }
    CHECK(statistics.rays == 0);
    CHECK(statistics.rays_skipped >= above);
    CHECK(statistics.rays_skipped <= above + cube.positions.size());
    CHECK(statistics.milliseconds > 0);
}

TEST_CASE("a sphere above a plane blocks the cone that it fills") {
    for (const double scale : {1e-6, 1.0, 1e6}) {
        Mesh scene = lookout();
        const glm::dvec3 center(0.5, 0.2, 2.5);
        append(scene, make_sphere(center, 1));
        scene = placed(scene, scale, glm::dvec3(0));
        const DirectionSet set;
        const Visibility visibility = bake(geometry_of(scene), set);
        const double half_angle = std::asin(1 / glm::length(center));
        int inside = 0;
        for (std::size_t i = 0; i < set.size(); ++i) {
            const glm::dvec3 d(set.directions()[i]);
            const double angle = std::acos(std::clamp(glm::dot(d, glm::normalize(center)), -1.0, 1.0));
            // The sphere's flat triangles lie slightly inside the sphere.
            if (d.z < 1e-4 || std::abs(angle - half_angle) < 1e-3) continue;
            inside += angle < half_angle ? 1 : 0;
            CHECK(visibility.seen(0, i) == (angle > half_angle));
        }
        CHECK(inside > 50);
        CHECK_FALSE(visibility.unoccluded(0));
    }
}

TEST_CASE("a far, large ground does not lift the shadow of what stands near") {
    Mesh scene = lookout();
    // A lid lies 0.001 above the vertex, and the corners of the ground are 1e5 away.
    append(scene, placed(make_rectangle(1), 0.05, glm::dvec3(0, 0, 0.02)));
    append(scene, placed(make_rectangle(1), 1e5, glm::dvec3(0, 0, -1e-4)));
    const Visibility visibility = bake(geometry_of(scene), few());
    for (std::size_t i = 0; i < few().size(); ++i) {
        if (few().directions()[i].z > 0.1F) CHECK_FALSE(visibility.seen(0, i));
    }
}

TEST_CASE("each side of a two-sided surface has a visibility of its own") {
    for (const double scale : {1e-6, 1.0, 1e6}) {
        Mesh sheet = placed(make_rectangle(3), scale, glm::dvec3(0.3, 0.2, 5));
        const std::size_t front = sheet.positions.size();
        Mesh back = sheet;
        flip_normals(back);
        append(sheet, back);
        CHECK(bake(geometry_of(sheet), few()).unoccluded_count() == 2 * front);

        Mesh ball = placed(make_cube(3), scale, glm::dvec3(-0.4, 0.1, 0.2));
        const std::size_t outside = ball.positions.size();
        Mesh inside = ball;
        flip_normals(inside);
        append(ball, inside);
        const Visibility visibility = bake(geometry_of(ball), few());
        for (std::size_t v = 0; v < ball.positions.size(); ++v) {
            CHECK(visibility.unoccluded(v) == (v < outside));
            if (v >= outside) CHECK(none_seen(visibility, v));
        }
    }
}

TEST_CASE("a hole lets the environment in, and faces that are there twice make no difference") {
    Mesh box = make_cube(1);
    // Removes the top, whose corners have upward normals.
    std::erase_if(box.triangles, [&](const glm::uvec3& t) { return box.normals[t.x].z > 0.5F; });
    flip_normals(box);
    const Visibility once = bake(geometry_of(box), few());
    Mesh twice = box;
    twice.triangles.insert(twice.triangles.end(), box.triangles.begin(), box.triangles.end());
    twice.triangles.emplace_back(0, 0, 1);
    const Visibility again = bake(geometry_of(twice), few());
    for (std::size_t v = 0; v < box.positions.size(); ++v) {
        // Rays from the rim pass the rim of the next wall within rounding.
        if (box.positions[v].z < 0) CHECK(std::ranges::equal(once.at(v), again.at(v)));
        if (box.normals[v].z < 0.5F) continue;
        // Seen from a corner of the floor, the opening is a square two units above, with one corner straight
        // overhead.
        for (std::size_t i = 0; i < few().size(); ++i) {
            const glm::vec3 d = few().directions()[i];
            if (d.z <= 0.01F) continue;
            const glm::vec3 at = box.positions[v] + d * (2 / d.z);
            const float out = std::max(std::abs(at.x), std::abs(at.y)) - 1;
            if (std::abs(out) > 1e-3F) CHECK(once.seen(v, i) == (out < 0));
        }
    }
}

TEST_CASE("a shifted object is traced only towards other objects, and sees what a new bake says") {
    // The object hides parts of itself; the floor is flat and wide, a pillar stands at each side.
    Mesh object = placed(make_cube(2), 0.3, {0, 0, 2});
    append(object, placed(make_cone(false), 0.4, {1.5, 0, 1}));
    const std::array others{placed(make_rectangle(8), 6, {0, 0, 0}), placed(make_cube(2), 0.5, {4, 0, 1}),
                            placed(make_cube(2), 0.5, {-4, 1, 1})};
    const auto scene = [&](const glm::dvec3& shift) {
        Mesh all = placed(object, 1, shift);
        for (const Mesh& other : others) append(all, other);
        return all;
    };
    std::vector<Ball> balls, balls_before;
    std::vector<Box> boxes, boxes_before;
    const glm::dvec3 shift(0.35, -0.2, 0.1);
    for (const Mesh& other : others) {
        for (const bool before : {false, true}) {
            const Mesh seen = placed(other, 1, before ? shift : glm::dvec3(0));
            (before ? balls_before : balls).push_back(ball_around(seen.positions));
            (before ? boxes_before : boxes).emplace_back().add(seen, glm::dmat4(1));
        }
    }
    const std::size_t own = object.positions.size();
    const Mesh before = scene(glm::dvec3(0)), now = scene(shift);
    const std::vector<Ball> removed{ball_around(std::span(before.positions).first(own))};
    const std::vector<Ball> added{ball_around(std::span(now.positions).first(own))};
    const VertexRun rest{.first = own, .last = now.positions.size(), .before = own};
    const ShiftedObject shifted{.vertices = {.first = 0, .last = own, .before = 0},
                                .shift = shift,
                                .others = {balls, balls_before, boxes, boxes_before}};
    const DirectionSet directions(1024);
    const Visibility first = bake(geometry_of(before), directions);
    BakeGeometry geometry = geometry_of(now);
    BakeStatistics kept, anew;
    FormerBake former{.visibility = first, .kept = {&rest, 1}, .disturbances = {added, removed}};
    geometry.every_ray = true;
    const Visibility truth = bake(geometry, directions, {}, &anew, &former);
    former.shifted = {&shifted, 1};
    const Visibility moved = bake(geometry, directions, {}, &kept, &former);
    CHECK(std::ranges::equal(moved.bits(), truth.bits()));
    CHECK(std::ranges::equal(moved.unoccluded(), truth.unoccluded()));
    CHECK(kept.rays < 2 * anew.rays / 3);
}

TEST_CASE("vertices that have not followed a change follow it with the next one") {
    const Mesh floor = placed(make_rectangle(16), 4, {0, 0, 0});
    const std::size_t given = floor.positions.size();
    std::vector<Mesh> scenes;
    std::vector<Ball> balls;
    for (const double x : {-2.0, 0.5, 1.5}) {
        const Mesh cube = placed(make_cube(2), 0.5, {x, 0.3, 1});
        balls.push_back(ball_around(cube.positions));
        append(scenes.emplace_back(floor), cube);
    }
    const DirectionSet directions(512);
    const Visibility earlier = bake(geometry_of(scenes[0]), directions),
                     former = bake(geometry_of(scenes[1]), directions),
                     truth = bake(geometry_of(scenes[2]), directions);
    Visibility mixed = former;
    std::vector<Known> known(mixed.vertices(), Known::former);
    for (std::size_t v = 0; v < given; ++v) {
        if (v % 3 == 0) mixed.take(v, earlier, v);
        if (v % 3 != 0) continue;
        known[v] = v % 6 == 0 ? Known::earlier : Known::nothing;
    }
    const VertexRun kept{.first = 0, .last = given, .before = 0};
    const FormerBake before{.visibility = mixed,
                            .kept = {&kept, 1},
                            .disturbances = {std::span(balls).subspan(2), std::span(balls).subspan(1, 1)},
                            .known = known,
                            .earlier = {std::span(balls).subspan(1), std::span(balls).first(2)}};
    BakeGeometry geometry = geometry_of(scenes[2]);
    BakeStatistics some;
    const Visibility all = bake(geometry, directions, {}, &some, &before);
    CHECK(std::ranges::equal(all.bits(), truth.bits()));
    CHECK(std::ranges::equal(all.unoccluded(), truth.unoccluded()));
    CHECK(some.rays + some.rays_skipped < given * directions.size() / 2);

    const std::vector<std::uint8_t> none(truth.vertices(), 0);
    geometry.needed = none;
    const Visibility idle = bake(geometry, directions, {}, &some, &before);
    CHECK(some.rays == 0);
    for (std::size_t v = 0; v < given; ++v) {
        if (known[v] == Known::nothing)
            CHECK(idle.unoccluded(v));
        else
            CHECK(std::ranges::equal(idle.at(v), mixed.at(v)));
    }
}

TEST_CASE("the result does not depend on the number of threads or the length of normals") {
    Mesh scene = make_sphere({0, 0, 1.5}, 1);
    append(scene, placed(make_rectangle(16), 3, glm::dvec3(0)));
    Visibility one;
    Visibility many;
    tbb::task_arena(1).execute([&] { one = bake(geometry_of(scene), few()); });
    for (glm::vec3& normal : scene.normals) normal *= 8.0F;
    tbb::task_arena(2).execute([&] { many = bake(geometry_of(scene), few()); });
    CHECK(std::ranges::equal(one.bits(), many.bits()));
    CHECK(std::ranges::equal(one.unoccluded(), many.unoccluded()));
    CHECK(one.unoccluded_count() > 0);
    CHECK(one.unoccluded_count() < one.vertices());
}

TEST_CASE("progress rises from 0 to 1 on the calling thread, and what it throws stops the work") {
    const Mesh sphere = make_sphere();
    const DirectionSet set;
    std::vector<double> reported;
    const std::thread::id here = std::this_thread::get_id();
    static_cast<void>(bake(geometry_of(sphere), set, [&](double fraction) {
        reported.push_back(fraction);
        CHECK(std::this_thread::get_id() == here);
    }));
    CHECK(reported.size() > 3);
    CHECK(reported.front() == 0);
    CHECK(reported.back() == 1);
    CHECK(std::ranges::is_sorted(reported));
    int calls = 0;
    const auto cancel = [&](double) {
        if (++calls == 2) throw Error(ErrorCode::cancelled, "enough");
    };
    check_error(ErrorCode::cancelled, CALL(bake(geometry_of(sphere), set, cancel)));
    CHECK(calls == 2);
}

TEST_CASE("nothing to bake is no mistake") {
    CHECK(bake({}, few()).vertices() == 0);
    const Mesh lonely{.positions = {{1, 2, 3}}, .normals = {{0, 1, 0}}, .triangles = {}};
    CHECK(bake(geometry_of(lonely), few()).unoccluded(0));
}

TEST_CASE("geometry that makes no sense is refused with the vertex or triangle at fault") {
    const auto message = [](const Mesh& mesh) { return error_of(CALL(bake(geometry_of(mesh), few()))); };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Mesh mesh = lookout();
    mesh.normals[1] = {0, 0, 0};
    CHECK(message(mesh).find("vertex 1 is zero") != std::string::npos);
    mesh.normals[1] = {0, nan, 0};
    CHECK(message(mesh).find("vertex 1 is not finite") != std::string::npos);
    mesh.normals.pop_back();
    CHECK(message(mesh).find("2 normals for 3 vertices") != std::string::npos);
    mesh = lookout();
    mesh.positions[2].x = nan;
    CHECK(message(mesh).find("vertex 2") != std::string::npos);
    mesh = lookout();
    mesh.triangles[0].z = 3;
    CHECK(message(mesh).find("triangle 0") != std::string::npos);
}

TEST_CASE("glass dims low orders of what lies behind it as it dims light") {
    constexpr int order = 4;
    // A roof of glass over the whole sky but for its rim, and a wall beside it that nothing passes.
    Mesh scene = lookout();
    append(scene, placed(make_rectangle(1), 100, {0, 0, 0.01}));
    const std::vector<glm::uvec3> glass_triangles(scene.triangles.begin() + 1, scene.triangles.end());
    std::vector<glm::uvec3> blocking = scene.triangles;
    for (std::size_t t = 1; t < blocking.size(); ++t) blocking[t] = glm::uvec3(blocking[t].x);
    const std::size_t wall = scene.triangles.size();
    append(scene, {.positions = {{0, -200, -200}, {0, 200, -200}, {-20, 0, 400}},
                   .normals = std::vector<glm::vec3>(3, {1, 0, 0}),
                   .triangles = {{0, 1, 2}}});
    for (glm::vec3& p : std::span(scene.positions).last(3)) p.x -= 5;
    blocking.push_back(scene.triangles[wall]);
    const RaySurface surface{.positions = scene.positions, .triangles = glass_triangles};
    const auto transmittance = [](const Ray& ray) { return 0.92 - 0.6 * std::pow(1 - ray.direction.z, 5); };
    const auto glass = std::make_shared<const BakeGlass>(
        BakeGlass{.surfaces = std::make_shared<const RayScene>(std::span(&surface, 1)),
                  .transmittance = transmittance,
                  .triangles = glass_triangles,
                  .key = "test"});
    for (const int count : {512, 2048}) {
        const DirectionSet set(count);
        BakeGeometry geometry{scene.positions, scene.normals, scene.triangles};
        geometry.blocking = blocking;
        const Visibility open = bake(geometry, set);
        geometry.glass = glass;
        const Visibility dimmed = bake(geometry, set);
        CHECK_FALSE(dimmed.unoccluded(0));
        std::vector<double> expected(psh_count(order)), found(psh_count(order)), harmonics(psh_count(order));
        std::vector<std::complex<double>> unused(psh_count(order));
        for (std::size_t i = 0; i < set.size(); ++i) {
            const glm::dvec3 d(set.directions()[i]);
            const bool under = std::max(std::abs(d.x), std::abs(d.y)) < 99 * d.z;
            CHECK((open.seen(0, i) || !dimmed.seen(0, i)));
            if (!open.seen(0, i)) continue;
            harmonics_at(order, d, harmonics, unused);
            const double weight = static_cast<double>(set.weights()[i]);
            const double factor = under ? transmittance({.direction = d}) : 1;
            for (std::size_t k = 0; k < found.size(); ++k) {
                expected[k] += weight * factor * harmonics[k];
                if (dimmed.seen(0, i)) found[k] += weight * harmonics[k];
            }
        }
        CAPTURE(count);
        double worst = 0;
        for (std::size_t k = 0; k < found.size(); ++k)
            worst = std::max(worst, std::abs(found[k] - expected[k]));
        INFO("worst coefficient " << worst << " of " << expected[0]);
        CHECK(worst < (count > 1000 ? 0.03 : 0.08) * expected[0]);
    }
}
