// SPDX-License-Identifier: MIT
#include "devices/mirrored_pixel.hpp"

#include <array>
#include <glm/geometric.hpp>
#include <optional>

#include "scene/camera.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

struct Seen {
    glm::dvec3 position, normal, mirrored;
};

/// Returns what a place of the image, in pixels, shows of the unit ball about the origin.
Seen seen_of_ball(const Projection& projection, int width, int height, const glm::dvec2& place) {
    const glm::dvec2 at = on_image_plane(projection, width, height, place.x, place.y);
    const Viewpoint& view = projection.view;
    const glm::dvec3 across = at.x * view.right + at.y * view.up;
    const glm::dvec3 from = view.orthographic ? view.eye + across : view.eye;
    const glm::dvec3 way = view.orthographic ? view.forward : glm::normalize(view.forward + across);
    const double middle = -glm::dot(from, way);
    const double half2 = middle * middle - glm::dot(from, from) + 1;
    REQUIRE(half2 > 0);
    const glm::dvec3 position = from + (middle - std::sqrt(half2)) * way;
    return {position, position, way - 2 * glm::dot(way, position) * position};
}

LaneVectors in_all(const glm::vec3& v) {
    LaneVectors out;
    for (std::size_t i = 0; i < kLanes; ++i) put(out, i, v);
    return out;
}

}  // namespace

TEST_CASE("Steps of mirrored directions are those from pixel to pixel") {
    constexpr int width = 96, height = 64;
    for (const bool orthographic : {false, true}) {
        for (const double sample_size : {1.0, 0.25}) {
            const Camera camera{.orthographic = orthographic,
                                .to_world = look_at({1, 2, 5}, {0.1, 0, 0}, {0.2, 1, 0})};
            Projection projection = project(camera, width, height);
            projection.sample_size = sample_size;
            for (const glm::dvec2 place : {glm::dvec2(48, 32), {40, 28}, {55, 37}}) {
                CAPTURES(orthographic, sample_size, place.x, place.y);
                const Seen here = seen_of_ball(projection, width, height, place);
                // A small triangle of the ball around the place, in every lane.
                LaneTriangles triangles;
                for (const std::size_t k : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
                    const double angle = 2 + 2.1 * static_cast<double>(k);
                    const glm::dvec2 corner = place + 0.4 * glm::dvec2(std::cos(angle), std::sin(angle));
                    const glm::vec3 of_ball(seen_of_ball(projection, width, height, corner).position);
                    triangles.corners[k] = triangles.normals[k] = in_all(of_ball);
                }
                // The sample's place is beside the shaded point.
                const glm::dvec2 beside = place + glm::dvec2(0.2, -0.1);
                const glm::vec2 at(on_image_plane(projection, width, height, beside.x, beside.y));
                LaneSamples samples;
                samples.right.value.fill(at.x);
                samples.up.value.fill(at.y);
                samples.width.value.fill(1);
                samples.height.value.fill(0.5F);
                const std::array positions{glm::vec3(here.position)};
                MirroredPixels pixels;
                mirrored_pixels(projection, width, height,
                                {.triangles = triangles,
                                 .facets = in_all(glm::vec3(here.normal)),
                                 .positions = positions,
                                 .normals = in_all(glm::vec3(here.normal))},
                                samples, pixels);
                const MirroredPixel pixel = pixels.at(kLanes - 1);
                const glm::dvec3 shift =
                    seen_of_ball(projection, width, height, beside).mirrored - here.mirrored;
                CHECK(glm::distance(glm::dvec3(pixel.shift), shift) < 0.04 * glm::length(shift));
                constexpr double part = 0.05;
                for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
                    const glm::dvec2 way = k == 0 ? glm::dvec2(part, 0) : glm::dvec2(0, part);
                    const glm::dvec3 there = (seen_of_ball(projection, width, height, place + way).mirrored -
                                              seen_of_ball(projection, width, height, place - way).mirrored) *
                                             (sample_size / (2 * part));
                    const double size = k == 0 ? 1 : 0.5;
                    CHECK(glm::distance(glm::dvec3(pixel.steps[k]), size * there) <
                          0.03 * size * glm::length(there));
                }
            }
        }
    }
}
