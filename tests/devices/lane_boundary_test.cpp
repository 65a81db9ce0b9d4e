// SPDX-License-Identifier: MIT
#include "devices/cpu/lane_boundary.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "devices/mirrored_pixel.hpp"
#include "material/film.hpp"
#include "shading/boundary_split.hpp"
#include "shading/ray_spread.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

struct Case {
    glm::dvec3 ray;
    Frame received;
    RaySpread spread;
};

/// Returns rays of many directions that meet a triangle from both sides.
std::array<Case, kLanes> some_rays() {
    std::array<Case, kLanes> out;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const double angle = 1.3 * static_cast<double>(i), z = i == 3 ? -1 : std::cos(0.9 + angle);
        const double flat = std::sqrt(1 - z * z);
        const glm::dvec3 ray(flat * std::cos(angle), flat * std::sin(angle), z);
        const glm::dvec3 hint(std::sin(2 * angle), std::cos(3 * angle), 0.3);
        out[i] = {ray, frame_with_x(-ray, hint), {}};
        out[i].spread.places = {glm::dvec3(0.01, 0.02, 0), glm::dvec3(0.003, -0.01, 0.02)};
        out[i].spread.directions = {glm::cross(ray, hint) * 0.01,
                                    glm::cross(ray, glm::cross(ray, hint)) * 0.02};
    }
    return out;
}

glm::dvec3 at(const LaneVectors& lanes, std::size_t i) {
    return glm::dvec3(vector_at(lanes, i));
}

/// Returns the matrix of a part as split_at() has it.
Mueller matrix_of(const LaneSplit& split, const LanePart& part, std::size_t i, double scale) {
    const auto block = [&](std::size_t k) { return static_cast<double>(part.block[k][i]); };
    const double angle =
        std::atan2(static_cast<double>(split.sine2[i]), static_cast<double>(split.cosine2[i])) / 2;
    return frame_rotation(angle) *
           (scale * mueller_of(ReflectionBlock<double>{block(0), block(1), block(2), block(3)}));
}

}  // namespace

TEST_CASE("sixteen rays at a boundary have the parts and spreads of single rays") {
    SmoothBoundary glass, pane, coated;
    glass.eta = 1.5;
    pane.eta = 1.6;
    pane.behind = SmoothBoundary::Behind::slab;
    coated.eta = 1.5;
    coated.film = film_table({.thickness = 400, .eta = {{1.3, 0.0}}, .wavelengths = {}}, 1, {1.5});
    const std::array<glm::vec3, 3> normals{glm::normalize(glm::vec3(0.2F, 0, 1)),
                                           glm::normalize(glm::vec3(0, -0.2F, 1)), glm::vec3(0, 0, 1)};
    const glm::dvec3 normal = glm::normalize(0.2 * glm::dvec3(normals[0]) + 0.3 * glm::dvec3(normals[1]) +
                                             0.5 * glm::dvec3(normals[2]));
    // Triangles of usual and of extreme sizes, and a narrow one.
    struct Size {
        float unit, width;
    };
    for (const Size& size : {Size{1, 1}, {1e-11F, 1}, {1e11F, 1}, {1, 1e-4F}}) {
        const float unit = size.unit;
        const std::array<glm::vec3, 3> corners{glm::vec3(0, 0, 0), unit * glm::vec3(1, 0.1F * size.width, 0),
                                               unit * glm::vec3(0.2F, size.width, 0.1F * size.width)};
        const glm::dvec3 facet = glm::normalize(glm::cross(glm::dvec3(corners[1]), glm::dvec3(corners[2])));
        std::array<Case, kLanes> rays = some_rays();
        BoundaryHits hits;
        for (std::size_t i = 0; i < kLanes; ++i) {
            for (glm::dvec3& place : rays[i].spread.places) place *= double{unit};
            put(hits.directions, i, glm::vec3(rays[i].ray));
            put(hits.received_x, i, glm::vec3(rays[i].received[0]));
            hits.distances[i] = 2 * unit;
            hits.b1[i] = 0.3F;
            hits.b2[i] = 0.5F;
            for (std::size_t k = 0; k < 2; ++k) {
                put(hits.places[k], i, glm::vec3(rays[i].spread.places[k]));
                put(hits.changes[k], i, glm::vec3(rays[i].spread.directions[k]));
            }
            for (std::size_t k = 0; k < 3; ++k) {
                put(hits.triangles.corners[k], i, corners[k]);
                put(hits.triangles.normals[k], i, normals[k]);
            }
        }
        for (const SmoothBoundary& boundary : {glass, pane, coated}) {
            LaneSplit split;
            split_lanes(boundary, hits, split);
            for (std::size_t i = 0; i < kLanes; ++i) {
                CAPTURES(boundary.eta, unit, size.width, i);
                const BoundarySplit single = split_at(boundary, facet, normal, rays[i].received);
                CHECK((split.inside[i] > 0) == single.inside);
                CHECK(glm::distance(at(split.facets, i), facet) < 1e-6);
                for (const bool reflects : {true, false}) {
                    const LanePart& part = reflects ? split.reflected : split.transmitted;
                    const BoundaryPart& of_single = reflects ? single.reflected : single.transmitted;
                    CHECK(static_cast<double>(part.block[0][i]) ==
                          doctest::Approx(of_single.share).epsilon(1e-4));
                    if (!(of_single.share > 0)) continue;
                    CHECK(glm::distance(at(part.towards_light, i), of_single.towards_light) < 1e-6);
                    // The frames of the light that arrives differ by a half turn at most.
                    CHECK(std::abs(glm::dot(at(split.s_axes, i), of_single.incident[0])) > 1 - 1e-5);
                    const double scale = reflects ? 1 : static_cast<double>(split.radiance_scale[i]);
                    const Mueller matrix = matrix_of(split, part, i, scale);
                    for (std::size_t row = 0; row < 4; ++row)
                        for (std::size_t column = 0; column < 4; ++column)
                            CHECK(std::abs(matrix(row, column) - of_single.mueller(row, column)) < 1e-4);
                    RaySpread spread = rays[i].spread;
                    spread.meet(rays[i].ray, 2 * double{unit}, facet);
                    const ShownTriangle triangle{.corners = corners, .normals = normals};
                    const double side = glm::dot(single.normal, normal) < 0 ? -1 : 1;
                    const std::array bends{side * bend_of_normal(triangle, spread.places[0], normal),
                                           side * bend_of_normal(triangle, spread.places[1], normal)};
                    if (reflects)
                        spread.reflect(rays[i].ray, single.normal, bends);
                    else if (boundary.behind == SmoothBoundary::Behind::body)
                        spread.refract(rays[i].ray, single.normal, bends, single.eta);
                    for (std::size_t k = 0; k < 2; ++k) {
                        const double size = 1 + glm::length(spread.directions[k]);
                        CHECK(glm::distance(at(part.changes[k], i), spread.directions[k]) < 1e-4 * size);
                    }
                }
            }
        }
    }
}

TEST_CASE("the frame of a ray along the normal is orthogonal to the ray") {
    SmoothBoundary pane;
    pane.eta = 1.5;
    pane.behind = SmoothBoundary::Behind::slab;
    std::mt19937 generator(5);
    std::normal_distribution<double> any;
    for (int turn = 0; turn < 100; ++turn) {
        BoundaryHits hits{};
        for (std::size_t i = 0; i < kLanes; ++i) {
            const glm::dvec3 normal =
                glm::normalize(glm::dvec3(any(generator), any(generator), any(generator)));
            const glm::dvec3 hint(any(generator), any(generator), any(generator));
            const Frame frame = frame_with_x(normal, hint);
            const std::array<glm::dvec3, 3> corners{glm::dvec3(0), frame[0], frame[1]};
            put(hits.directions, i, glm::vec3(-normal));
            put(hits.received_x, i, glm::vec3(frame[0]));
            hits.distances[i] = 1;
            hits.b1[i] = hits.b2[i] = 0.3F;
            for (std::size_t k = 0; k < 3; ++k) {
                put(hits.triangles.corners[k], i, glm::vec3(corners[k]));
                put(hits.triangles.normals[k], i, glm::vec3(normal));
            }
        }
        LaneSplit split;
        split_lanes(pane, hits, split);
        for (std::size_t i = 0; i < kLanes; ++i)
            CHECK(std::abs(glm::dot(at(split.s_axes, i), at(hits.directions, i))) < 1e-3);
    }
}
