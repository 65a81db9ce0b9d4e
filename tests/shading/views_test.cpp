// SPDX-License-Identifier: MIT
#include "polarization/views.hpp"

#include "directions.hpp"
#include "material/brute_force.hpp"
#include "shading/reflected_light.hpp"
#include "shading/shade.hpp"
#include "specular/lane_mirror.hpp"
#include "test.hpp"
#include "transfer/vertex_light.hpp"

using namespace nicol;

namespace {

constexpr std::size_t kPoints = 21;  // a block and a part of one

struct Points {
    std::vector<glm::vec3> positions, normals;
    Viewpoint camera;
    std::vector<double> turns;    // angles from the camera's frames to those of the rays
    std::vector<Viewpoint> rays;  // viewpoints that look along the camera's rays
};

Points seen_points() {
    Points out;
    out.camera.eye = {0.5, -0.2, 4};
    out.camera.forward = {0, 0, -1};
    out.camera.right = {1, 0, 0};
    std::mt19937 random(5);
    for (std::size_t i = 0; i < kPoints; ++i) {
        out.positions.emplace_back(random_direction(random));
        const glm::dvec3 towards = out.camera.towards(glm::dvec3(out.positions.back()));
        out.normals.emplace_back(glm::normalize(random_direction(random) + 1.5 * towards));
        out.turns.push_back(0.3 * static_cast<double>(i));
        const Frame frame = out.camera.frame(towards);
        const glm::dvec3 x = std::cos(out.turns[i]) * frame[0] + std::sin(out.turns[i]) * frame[1];
        out.rays.push_back(
            {.orthographic = true, .eye = {}, .forward = -towards, .up = glm::cross(towards, x), .right = x});
    }
    return out;
}

// Checks that the rays' Stokes vectors are those of the camera, in the rays' frames.
void check_equal(const Points& points, std::span<const glm::vec4> of_camera,
                 std::span<const glm::vec4> of_rays) {
    double largest = 0;
    for (std::size_t i = 0; i < kPoints; ++i) {
        const Stokes expected = rotated(Stokes(of_camera[i]), points.turns[i]);
        CHECK(glm::distance(Stokes(of_rays[i]), expected) < 2e-5);
        largest = std::max(largest, std::hypot(expected[1], expected[2]));
    }
    CHECK(largest > 0.01);
}

}  // namespace

TEST_CASE("points that rays see leave the light that the camera sees, in the frames of the rays") {
    const Points points = seen_points();
    const LightLayout layout(4, LightKind::full);
    VertexLight light(layout, 1, kPoints);
    Relight(layout, test::random_light(4, 1, static_cast<int>(LightKind::full), 9))
        .run(points.normals, 0, light.blocks(), light);
    const MaterialPtr material = pplastic({.diffuse_reflectance = {0.2}, .alpha = 0.3});
    const ResponseTable table(*material, layout, 1);
    const std::vector<std::uint8_t> all(kPoints, 1);
    const auto shaded = [&](const Views& views) {
        std::vector<glm::vec4> out(kPoints);
        const std::vector<std::span<glm::vec4>> channels{out};
        Shade(layout).run(table, light, views, points.positions, points.normals, all, 0, kPoints, channels);
        return out;
    };
    check_equal(points, shaded(points.camera), shaded(Views(points.rays)));
}

TEST_CASE("rays see local lights reflected as the camera does") {
    const Points points = seen_points();
    const MaterialPtr material = pplastic({.diffuse_reflectance = {0.2}, .alpha = 0.3});
    LaneLight light;
    light.points = 0xFFFF;
    light.irradiance.resize(1);
    for (std::size_t i = 0; i < kLanes; ++i) {
        put(light.towards, i, glm::normalize(glm::vec3(0.3F, 0.1F, 1)));
        light.irradiance[0][0][i] = 10;
    }
    const auto reflected = [&](const Views& views) {
        std::vector<glm::vec4> out;
        for (std::size_t first = 0; first < kPoints; first += kLanes) {
            const std::size_t count = std::min(kLanes, kPoints - first);
            ReflectedLight of;
            of.set(views.subspan(first, count), std::span(points.positions).subspan(first, count),
                   std::span(points.normals).subspan(first, count));
            std::array<Lanes, 4> sum{};
            of.add(*material, nullptr, light, 0xFFFF, 1, {&sum, 1});
            for (std::size_t i = 0; i < count; ++i)
                out.emplace_back(sum[0][i], sum[1][i], sum[2][i], sum[3][i]);
        }
        return out;
    };
    check_equal(points, reflected(points.camera), reflected(Views(points.rays)));
}

TEST_CASE("rays are mirrored as the camera's are") {
    const Points points = seen_points();
    const std::span positions = std::span(points.positions).first(kLanes);
    const std::span normals = std::span(points.normals).first(kLanes);
    const glm::dmat3 rotation = some_rotation();
    const LaneMirror camera = mirror_views(points.camera, rotation, positions, normals);
    const LaneMirror rays =
        mirror_views(Views(std::span(points.rays).first(kLanes)), rotation, positions, normals);
    for (std::size_t i = 0; i < kLanes; ++i) {
        CHECK(glm::distance(vector_at(camera.d, i), vector_at(rays.d, i)) < 1e-6F);
        CHECK(glm::distance(vector_at(camera.local, i), vector_at(rays.local, i)) < 1e-6F);
        const Stokes s(1, static_cast<double>(camera.frame_cosine[i]),
                       -static_cast<double>(camera.frame_sine[i]), 0);
        const Stokes turned = rotated(s, points.turns[i]);
        CHECK(std::abs(turned[1] - static_cast<double>(rays.frame_cosine[i])) < 1e-5);
        CHECK(std::abs(turned[2] + static_cast<double>(rays.frame_sine[i])) < 1e-5);
    }
}
