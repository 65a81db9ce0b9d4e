// SPDX-License-Identifier: MIT
#include "geometry/ray_scene.hpp"

#include <bit>

#include "directions.hpp"
#include "geometry/embree.hpp"
#include "geometry/mesh.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

RaySurface surface(const Mesh& mesh) {
    return {mesh.positions, mesh.triangles};
}

}  // namespace

TEST_CASE("the nearest of all triangles is hit, where the brute-force search hits") {
    const Mesh ball = make_sphere({0.2, 0, 0}, 0.7);
    Mesh cube = make_cube(3);
    for (glm::vec3& p : cube.positions) p = 0.4F * p + glm::vec3(0.5F, 0.3F, 0.1F);
    const RaySurface surfaces[] = {surface(ball), {}, surface(cube)};
    const RayScene scene(surfaces);
    std::mt19937 random(1);
    int hits[3] = {0, 0, 0};
    for (int i = 0; i < 300; ++i) {
        const glm::dvec3 origin = 3.0 * random_direction(random);
        const glm::dvec3 target = 0.8 * random_direction(random);
        const glm::dvec3 direction = glm::normalize(target - origin);
        double nearest = std::numeric_limits<double>::infinity();
        for (const RaySurface& s : surfaces) {
            for (const glm::uvec3& t : s.triangles) {
                const glm::dvec3 a(s.positions[t.x]), u = glm::dvec3(s.positions[t.y]) - a,
                                                      v = glm::dvec3(s.positions[t.z]) - a;
                const glm::dvec3 p = glm::cross(direction, v);
                const double determinant = glm::dot(u, p);
                const glm::dvec3 to = origin - a;
                const double b1 = glm::dot(to, p) / determinant;
                const glm::dvec3 q = glm::cross(to, u);
                const double b2 = glm::dot(direction, q) / determinant;
                const double distance = glm::dot(v, q) / determinant;
                if (b1 >= 0 && b2 >= 0 && b1 + b2 <= 1 && distance > 0) nearest = std::min(nearest, distance);
            }
        }
        const auto hit = scene.intersect({.origin = origin, .direction = direction});
        REQUIRE(hit.has_value() == std::isfinite(nearest));
        if (!hit) continue;
        ++hits[hit->surface];
        CHECK(hit->distance == doctest::Approx(nearest).epsilon(1e-5));
        const RaySurface& s = surfaces[hit->surface];
        const glm::uvec3& t = s.triangles[hit->triangle];
        const glm::dvec3 point = (1 - hit->b1 - hit->b2) * glm::dvec3(s.positions[t.x]) +
                                 hit->b1 * glm::dvec3(s.positions[t.y]) +
                                 hit->b2 * glm::dvec3(s.positions[t.z]);
        CHECK(glm::distance(point, origin + nearest * direction) < 1e-5);
    }
    CHECK(hits[0] > 50);
    CHECK(hits[1] == 0);
    CHECK(hits[2] > 20);
}

TEST_CASE("only distances in range count") {
    const Mesh square = make_rectangle(1);
    const RaySurface surfaces[] = {surface(square)};
    const RayScene scene(surfaces);
    const Ray ray{.origin = {0.1, 0.2, 5}, .direction = {0, 0, -1}};
    REQUIRE(scene.intersect(ray).has_value());
    CHECK(scene.intersect(ray)->distance == doctest::Approx(5));
    Ray late = ray;
    late.nearest = 5.01;
    CHECK(!scene.intersect(late).has_value());
    Ray early = ray;
    early.farthest = 4.99;
    CHECK(!scene.intersect(early).has_value());
    Ray away = ray;
    away.direction = {0, 0, 1};
    CHECK(!scene.intersect(away).has_value());
}

TEST_CASE("no ray leaves a closed surface and no surface hides itself, large or small, near or far") {
    std::mt19937 random(2);
    for (const double radius : {1e-30, 1e-6, 1.0, 1e6}) {
        for (const double away : {0.0, 100.0}) {
            CAPTURES(radius, away);
            const glm::dvec3 center(away * radius, 0, 0);
            const Mesh ball = make_sphere(center, radius);
            const RaySurface surfaces[] = {surface(ball)};
            const RayScene scene(surfaces);
            int wrong = 0;
            for (int i = 0; i < 20000; ++i) {
                const glm::uvec3& t = ball.triangles[static_cast<std::size_t>(i) % ball.triangles.size()];
                const glm::dvec3 a(ball.positions[t.x]), b(ball.positions[t.y]), c(ball.positions[t.z]);
                const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
                const glm::dvec3 point = 0.5 * a + 0.3 * b + 0.2 * c;
                glm::dvec3 direction = random_direction(random);
                if (std::abs(glm::dot(direction, normal)) < 0.02) continue;
                const bool inwards = glm::dot(direction, normal) < 0;
                // From outside the ball is convex, and from inside it has no gap. Either sign of the normal
                // must work.
                const double offset =
                    ray_offset({ball.positions[t.x], ball.positions[t.y], ball.positions[t.z]});
                const Ray ray = leaving(point, i % 2 == 0 ? normal : -normal, direction, offset);
                wrong += scene.occluded(ray) == inwards ? 0 : 1;
            }
            CHECK(wrong == 0);
            for (int i = 0; i < 100; ++i) {
                const auto hit = scene.intersect({.origin = center, .direction = random_direction(random)});
                REQUIRE(hit);
                CHECK(hit->distance / radius == doctest::Approx(1).epsilon(0.01));
            }
        }
    }
}

TEST_CASE("what lies above a point hides what is behind it") {
    const Mesh square = make_rectangle(1);
    const RaySurface surfaces[] = {surface(square)};
    const RayScene scene(surfaces);
    CHECK(scene.occluded({.origin = {0.5, 0.5, -1}, .direction = {0, 0, 1}}));
    CHECK(!scene.occluded({.origin = {1.5, 0.5, -1}, .direction = {0, 0, 1}}));
    CHECK(!scene.occluded({.origin = {0.5, 0.5, -1}, .direction = {0, 0, -1}}));
}

TEST_CASE("a packet of rays is sixteen rays, each with an end and a place of its own") {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> uniform;
    for (const float size : {1e-20F, 1.0F, 1e6F}) {
        CAPTURE(size);
        const auto scaled = [size](Mesh mesh) {
            for (glm::vec3& p : mesh.positions) p *= size;
            return mesh;
        };
        const Mesh ball = scaled(make_sphere({0, 0, 0}, 1));
        const Mesh floor = scaled(make_rectangle(2));
        // Every second triangle of the floor is absent.
        const Presence present = [](std::uint32_t triangle, float, float) { return triangle % 2 == 0; };
        const RaySurface surfaces[] = {surface(ball), {floor.positions, floor.triangles, present}};
        const RayScene scene(surfaces);
        int hidden = 0;
        int seen = 0;
        for (int n = 0; n < 200; ++n) {
            RayPacket packet{};
            const auto active = static_cast<std::uint16_t>(random());
            std::uint16_t expected = 0;
            for (std::size_t i = 0; i < RayPacket::kRays; ++i) {
                const glm::vec3 origin = (2 * size) * glm::vec3(random_direction(random));
                const glm::vec3 direction(glm::normalize(
                    glm::dvec3(size * glm::vec3(random_direction(random))) - glm::dvec3(origin)));
                const float farthest =
                    i % 4 == 0 ? std::numeric_limits<float>::infinity() : 3 * size * uniform(random);
                std::tie(packet.origin_x[i], packet.origin_y[i], packet.origin_z[i]) =
                    std::tie(origin.x, origin.y, origin.z);
                std::tie(packet.direction_x[i], packet.direction_y[i], packet.direction_z[i]) =
                    std::tie(direction.x, direction.y, direction.z);
                packet.farthest[i] = farthest;
                const Ray ray{.origin = origin,
                              .direction = direction,
                              .farthest = static_cast<double>(farthest) * (1 - 1e-4) -
                                          ray_offset({origin, origin, origin})};
                const bool hits = scene.intersect(ray).has_value();
                if (hits && (active >> i & 1) != 0) expected |= static_cast<std::uint16_t>(1U << i);
            }
            CHECK(scene.occluded(packet, active) == expected);
            hidden += std::popcount(expected);
            seen += std::popcount(active) - std::popcount(expected);
        }
        CHECK(hidden > 200);
        CHECK(seen > 200);
    }
}

TEST_CASE("many rays have the hits of single rays, close to each other or not") {
    const Mesh ball = make_sphere({0.2, 0, 0}, 0.7), other = make_sphere({-0.5, 0.4, 0}, 0.5);
    const RaySurface surfaces[] = {
        surface(ball), {.positions = other.positions, .triangles = other.triangles, .front_only = true}};
    const RayScene scene(surfaces);
    for (const double spread : {0.05, 3.0}) {
        std::mt19937 random(1);
        std::vector<Ray> rays;
        for (int i = 0; i < 100; ++i) {
            const glm::dvec3 origin = glm::dvec3(0, 0, 2) + spread * random_direction(random);
            const glm::dvec3 target = 0.6 * random_direction(random);
            rays.push_back({.origin = origin, .direction = glm::normalize(target - origin), .nearest = 0.1});
        }
        std::vector<std::optional<RayHit>> hits(rays.size(), RayHit{});
        scene.intersect(rays, hits);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            CAPTURES(spread, i);
            const std::optional<RayHit> single = scene.intersect(rays[i]);
            REQUIRE(hits[i].has_value() == single.has_value());
            if (!single) continue;
            CHECK(hits[i]->surface == single->surface);
            CHECK(hits[i]->triangle == single->triangle);
            CHECK(hits[i]->distance == doctest::Approx(single->distance).epsilon(1e-5));
            CHECK(std::abs(hits[i]->b1 - single->b1) < 1e-3);
            CHECK(std::abs(hits[i]->b2 - single->b2) < 1e-3);
        }
    }
}

TEST_CASE("a packet finds the hits of single rays, at any scale and with any numbers of triangles") {
    const Mesh ball = make_sphere({0.2, 0, 0}, 0.7);
    std::vector<glm::vec3> tiny = ball.positions;
    for (glm::vec3& p : tiny) p *= 1e-8F;
    const std::vector<TriangleNumbers> numbers{{0, 7}, {.first = 40, .number = 2000, .back = 3000}};
    const RaySurface surfaces[] = {
        {.positions = ball.positions, .triangles = ball.triangles},
        {.positions = ball.positions, .triangles = ball.triangles, .numbers = numbers},
        {.positions = tiny, .triangles = ball.triangles}};
    for (std::size_t s = 0; s < std::size(surfaces); ++s) {
        const RayScene scene(std::span(&surfaces[s], 1));
        const double scale = s == 2 ? 1e-8 : 1;
        std::mt19937 random(1);
        int found = 0, missed = 0;
        for (const double spread : {0.05, 3.0}) {
            CAPTURES(s, spread);
            RayPacket packet{};
            packet.farthest.fill(std::numeric_limits<float>::infinity());
            for (std::size_t i = 0; i < RayPacket::kRays; ++i) {
                // Half of the rays begin inside.
                const glm::vec3 origin(scale * (glm::dvec3(0, 0, i % 2) + spread * random_direction(random)));
                const glm::vec3 direction(random_direction(random));
                packet.origin_x[i] = origin.x;
                packet.origin_y[i] = origin.y;
                packet.origin_z[i] = origin.z;
                packet.direction_x[i] = direction.x;
                packet.direction_y[i] = direction.y;
                packet.direction_z[i] = direction.z;
            }
            constexpr std::uint16_t active = 0xF7FE;
            HitPacket hits{};
            const std::uint16_t hit = scene.intersect(packet, active, hits);
            CHECK((hit & ~active) == 0);
            for (std::size_t i = 0; i < RayPacket::kRays; ++i) {
                if ((active >> i & 1) == 0) continue;
                CAPTURE(i);
                const auto single = scene.intersect(
                    {.origin = {packet.origin_x[i], packet.origin_y[i], packet.origin_z[i]},
                     .direction = {packet.direction_x[i], packet.direction_y[i], packet.direction_z[i]}});
                REQUIRE((hit >> i & 1) == (single ? 1 : 0));
                ++(single ? found : missed);
                if (!single) continue;
                CHECK(hits.surface[i] == 0);
                CHECK(hits.triangle[i] == single->triangle);
                CHECK(static_cast<double>(hits.distance[i]) ==
                      doctest::Approx(single->distance).epsilon(1e-5));
                CHECK(std::abs(static_cast<double>(hits.b1[i]) - single->b1) < 1e-3);
                CHECK(std::abs(static_cast<double>(hits.b2[i]) - single->b2) < 1e-3);
            }
            CHECK(scene.intersect(packet, 0, hits) == 0);
        }
        CHECK(found > 5);
        CHECK(missed > 2);
    }
}

TEST_CASE("a lamp's own surface does not hide it, what lies before it does") {
    std::mt19937 random(6);
    for (const double size : {1e-3, 1.0, 1e5}) {
        const glm::dvec3 far_away = size * glm::dvec3(3, 2, 1);
        const Mesh lamp = make_sphere(far_away, 0.2 * size);
        const Mesh ground = make_sphere({0, 0, 0}, size);
        const RaySurface surfaces[] = {surface(ground), surface(lamp)};
        const RayScene scene(surfaces);
        int wrong = 0;
        int tested = 0;
        for (int i = 0; i < 20000; ++i) {
            double offset = 0;
            const auto point_of = [&](const Mesh& mesh, glm::dvec3& normal) {
                const glm::uvec3& t = mesh.triangles[random() % mesh.triangles.size()];
                offset = std::max(
                    offset, ray_offset({mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]}));
                const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
                normal = glm::normalize(glm::cross(b - a, c - a));
                return 0.5 * a + 0.3 * b + 0.2 * c;
            };
            glm::dvec3 normal, facing;
            const glm::dvec3 point = point_of(ground, normal);
            const glm::dvec3 end = point_of(lamp, facing);
            const double distance = glm::distance(point, end);
            const glm::dvec3 direction = (end - point) / distance;
            if (std::abs(glm::dot(direction, normal)) < 0.02 || std::abs(glm::dot(direction, facing)) < 0.02)
                continue;
            const bool hidden = glm::dot(direction, normal) < 0 || glm::dot(direction, facing) > 0;
            Ray ray = leaving(point, normal, direction, offset);
            ray.farthest = distance;
            const glm::vec3 origin(ray.origin);
            RayPacket packet{};
            packet.origin_x.fill(origin.x);
            packet.origin_y.fill(origin.y);
            packet.origin_z.fill(origin.z);
            packet.direction_x.fill(static_cast<float>(direction.x));
            packet.direction_y.fill(static_cast<float>(direction.y));
            packet.direction_z.fill(static_cast<float>(direction.z));
            packet.farthest.fill(static_cast<float>(distance));
            wrong += scene.occluded(ray) == hidden ? 0 : 1;
            wrong += scene.occluded(packet, 0x0FFF) == (hidden ? 0x0FFF : 0) ? 0 : 1;
            packet.farthest.fill(0);
            ray.farthest = 0;
            wrong += scene.occluded(packet, 0xFFFF) == 0 && !scene.occluded(ray) ? 0 : 1;
            ++tested;
        }
        CHECK(tested > 15000);
        CHECK(wrong == 0);
    }
}

TEST_CASE("only what lies nearer than the distance hides, at any scale") {
    for (const double scale : {1e-8, 1.0, 1e6}) {
        const Mesh square = transformed(make_rectangle(1), glm::scale(glm::dmat4(1.0), glm::dvec3(scale)));
        const RaySurface surfaces[] = {surface(square)};
        const RayScene scene(surfaces);
        const glm::dvec3 point(0.5 * scale, 0.5 * scale, -scale), up(0, 0, 1);
        CAPTURE(scale);
        const auto occluded = [&](double farthest) {
            return scene.occluded({.origin = point, .direction = up, .farthest = farthest});
        };
        CHECK(occluded(1.01 * scale));
        CHECK(!occluded(0.99 * scale));
        CHECK(!occluded(0));
        // The ray starts on the side towards which it leaves.
        for (const double side : {-1.0, 1.0}) {
            const Ray ray = leaving(point, up, side * up, 0.5 * scale);
            CHECK(glm::length(ray.origin - (point + side * 0.5 * scale * up)) < 1e-9 * scale);
            CHECK(ray.direction == side * up);
        }
    }
}

TEST_CASE("rays pass where a surface is not, one by one and in packets") {
    MESSAGE("Embree ", embree::library().version());
    const std::array<glm::vec3, 4> positions{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}};
    const std::array<glm::uvec3, 2> triangles{{{0, 1, 2}, {0, 2, 3}}};
    // Only the part of triangle 1 near its corner 2 at (-1, 1) is present.
    const auto present = [](std::uint32_t triangle, float b1, float b2) {
        return triangle == 1 && b2 > 0.5F && b1 < 0.5F;
    };
    const RaySurface surfaces[] = {{positions, triangles, present}};
    const RayScene scene(surfaces);
    RayPacket packet{};
    unsigned expected = 0;
    for (std::size_t i = 0; i < RayPacket::kRays; ++i) {
        const glm::dvec3 origin(-0.9 + 0.55 * static_cast<double>(i % 4),
                                -0.85 + 0.55 * static_cast<double>(i / 4), 2);
        const double b2 = (origin.y - origin.x) / 2;
        const bool there = b2 > 0.5;
        expected |= (there ? 1U : 0U) << i;
        const Ray ray{.origin = origin, .direction = {0, 0, -1}};
        CHECK(scene.intersect(ray).has_value() == there);
        CHECK(scene.occluded(ray) == there);
        packet.origin_x[i] = static_cast<float>(origin.x);
        packet.origin_y[i] = static_cast<float>(origin.y);
        packet.origin_z[i] = 2;
        packet.direction_z[i] = -1;
        packet.farthest[i] = std::numeric_limits<float>::infinity();
    }
    CHECK(expected != 0);
    CHECK(scene.occluded(packet, 0xffff) == expected);
}

TEST_CASE(
    "rays pass the backs of a surface of which only the front counts, and meet the other side's triangles") {
    const std::vector<glm::vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<glm::uvec3> both{{0, 1, 2}, {0, 2, 1}};  // the front of the first faces +z
    const RaySurface surfaces[] = {{.positions = corners, .triangles = both, .front_only = true}};
    const RayScene scene(surfaces);
    const auto from = [&](double z) {
        return scene.intersect({.origin = {0.2, 0.2, z}, .direction = {0, 0, z > 0 ? -1 : 1}});
    };
    CHECK(from(1).value().triangle == 0);
    CHECK(from(-1).value().triangle == 1);
    const RaySurface one[] = {
        {.positions = corners, .triangles = std::span(both).first(1), .front_only = true}};
    const RayScene half(one);
    const Ray up{.origin = {0.2, 0.2, -1}, .direction = {0, 0, 1}};
    CHECK_FALSE(half.intersect(up).has_value());
    CHECK_FALSE(half.occluded(up));
    CHECK(half.occluded({.origin = {0.2, 0.2, 1}, .direction = {0, 0, -1}}));
}

TEST_CASE("a scene of parts has the hits of one surface, to the last bit") {
    const Mesh ball = make_sphere({0.2, 0.1, 0}, 0.7);
    Mesh cube = make_cube(3);
    for (glm::vec3& p : cube.positions) p = 0.4F * p + glm::vec3(0.5F, 0.3F, 0.1F);
    const auto striped = [](std::uint32_t triangle, float, float) { return triangle % 3 != 0; };
    Mesh both = ball;
    const auto of_cube = static_cast<std::uint32_t>(ball.positions.size());
    const auto balls = static_cast<std::uint32_t>(ball.triangles.size());
    both.positions.insert(both.positions.end(), cube.positions.begin(), cube.positions.end());
    for (const glm::uvec3& t : cube.triangles) both.triangles.push_back(t + of_cube);
    const RaySurface one{both.positions, both.triangles, [&](std::uint32_t triangle, float b1, float b2) {
                             return triangle < balls ? striped(triangle, b1, b2) : true;
                         }};
    const RaySurface masked{ball.positions, ball.triangles, striped}, whole = surface(cube);
    const RayScene flat(std::span(&one, 1));
    const RayScene parts({{std::make_shared<const RayScene>(std::span(&masked, 1)), {{0, 0}}},
                          {std::make_shared<const RayScene>(std::span(&whole, 1)), {{0, balls}}}});
    CHECK_FALSE(parts.scaled());
    std::mt19937 random(3);
    int hits[2] = {0, 0};
    unsigned blocked = 0;
    for (int i = 0; i < 400; ++i) {
        const Ray ray{.origin = 3.0 * random_direction(random), .direction = random_direction(random)};
        const Ray inwards{.origin = ray.origin,
                          .direction = glm::normalize(0.8 * random_direction(random) - ray.origin)};
        for (const Ray& each : {ray, inwards}) {
            const auto expected = flat.intersect(each), hit = parts.intersect(each);
            REQUIRE(hit.has_value() == expected.has_value());
            CHECK(parts.occluded(each) == flat.occluded(each));
            if (!hit) continue;
            ++hits[hit->surface];
            CHECK(hit->surface == (hit->triangle < balls ? 0 : 1));
            CHECK(hit->triangle == expected->triangle);
            CHECK(hit->distance == expected->distance);
            CHECK(hit->b1 == expected->b1);
            CHECK(hit->b2 == expected->b2);
        }
        for (const double spread : {0.1, 3.0}) {
            RayBundle bundle{};
            for (std::size_t r = 0; r < RayBundle::kRays; ++r) {
                const glm::vec3 direction(
                    glm::normalize(inwards.direction + spread * random_direction(random)));
                bundle.x[r] = direction.x;
                bundle.y[r] = direction.y;
                bundle.z[r] = direction.z;
            }
            const glm::vec3 origin(ray.origin);
            CHECK(parts.occluded(origin, bundle, 0xfff7) == flat.occluded(origin, bundle, 0xfff7));
            blocked += flat.occluded(origin, bundle, 0xfff7) != 0 ? 1 : 0;
        }
    }
    CHECK(hits[0] > 50);
    CHECK(hits[1] > 20);
    CHECK(blocked > 50);
}

TEST_CASE("hits have the numbers of their triangles, and those of the back are the back's") {
    const std::vector<glm::vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {3, 0, 0}, {2, 1, 0}};
    const std::vector<glm::uvec3> triangles{{0, 1, 2}, {3, 4, 5}};
    const std::vector<TriangleNumbers> numbers{{0, 7}, {.first = 1, .number = 20, .back = 5}};
    const RaySurface surface{.positions = corners, .triangles = triangles, .numbers = numbers};
    const RayScene scene(std::span(&surface, 1));
    const auto from = [&](double x, double z) {
        return scene.intersect({.origin = {x, 0.5, z}, .direction = {0, 0, z > 0 ? -1 : 1}}).value();
    };
    CHECK(from(0.2, 1).triangle == 7);
    CHECK(from(0.2, -1).triangle == 7);
    CHECK(from(0.2, -1).b1 == doctest::Approx(0.2));
    CHECK(from(2.2, 1).triangle == 20);
    CHECK(from(2.2, 1).b1 == doctest::Approx(0.2));
    CHECK(from(2.2, -1).triangle == 25);
    CHECK(from(2.2, -1).b1 == doctest::Approx(0.5));
    CHECK(from(2.2, -1).b2 == doctest::Approx(0.2));
}

TEST_CASE("an empty scene has no hits") {
    const RayScene scene(std::span<const RaySurface>{});
    CHECK(!scene.intersect({.origin = {0, 0, 0}, .direction = {0, 0, 1}}).has_value());
    CHECK(!scene.occluded({.origin = {0, 0, 0}, .direction = {0, 0, 1}}));
}

TEST_CASE("surfaces that are not sound are refused by name") {
    const std::vector<glm::vec3> good{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<glm::uvec3> one{{0, 1, 2}};
    const auto refused = [](const RaySurface& bad, const char* what) {
        const RaySurface surfaces[] = {{}, bad};
        check_error(ErrorCode::invalid_argument, CALL(RayScene{surfaces}), "surface 1", what);
    };
    const RaySurface surfaces[] = {{good, one}};
    CHECK_NOTHROW(RayScene{surfaces});
    for (const float value :
         {std::numeric_limits<float>::quiet_NaN(), 2e15F, -std::numeric_limits<float>::infinity()}) {
        std::vector<glm::vec3> bad = good;
        bad[2].y = value;
        refused({bad, one}, "vertex 2");
    }
    const std::vector<glm::uvec3> beyond{{0, 1, 2}, {0, 3, 1}};
    refused({good, beyond}, "triangle 1");
}
