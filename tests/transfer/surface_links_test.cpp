// SPDX-License-Identifier: MIT
// Tests of links between vertices and the surfaces that they see.
#include "transfer/surface_links.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

using namespace nicol;

namespace {

// The floor z = 0 and a ceiling at z = 1, both large, one-sided and facing each other. Vertex 8 lies in the
// middle of the floor.
struct Slot {
    std::vector<glm::vec3> positions{{-50, -50, 0}, {50, -50, 0}, {50, 50, 0}, {-50, 50, 0},
                                     {-50, -50, 1}, {50, -50, 1}, {50, 50, 1}, {-50, 50, 1}};
    std::vector<glm::vec3> normals{{0, 0, 1},  {0, 0, 1},  {0, 0, 1},  {0, 0, 1},
                                   {0, 0, -1}, {0, 0, -1}, {0, 0, -1}, {0, 0, -1}};
    std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}, {4, 6, 5}, {4, 7, 6}};
    TriangleSides sides{.fronts = {0, 1, 2, 3}, .backs = {}};

    Slot() {
        positions.emplace_back(0, 1, 0);
        normals.emplace_back(0, 0, 1);
    }
    [[nodiscard]] BakeGeometry geometry() const {
        return {.positions = positions, .normals = normals, .triangles = triangles};
    }
    [[nodiscard]] std::vector<SurfaceLink> links_of_middle(const DirectionSet& directions) const {
        const Visibility visibility = bake(geometry(), directions);
        std::vector<SurfaceLink> links;
        mean_length = LinkSearch(geometry(), sides, directions, visibility).find(8, links);
        return links;
    }
    mutable float mean_length = 0;  // harmonic mean, of the last call
};

double solid_angle(const std::vector<SurfaceLink>& links) {
    return std::accumulate(links.begin(), links.end(), 0.0, [](double sum, const SurfaceLink& link) {
        return sum + double{link.solid_angle};
    });
}

}  // namespace

TEST_CASE("links lead along their directions to the surface, and stand for all that it hides") {
    const Slot slot;
    const DirectionSet directions(2048);
    const std::vector<SurfaceLink> links = slot.links_of_middle(directions);
    CHECK(links.size() >= 40);
    CHECK(links.size() <= kLinkStrata);
    // The ceiling hides all but a low strip of about 1 / 50 radians.
    CHECK(solid_angle(links) == doctest::Approx(2 * std::numbers::pi).epsilon(0.03));
    // The mean of the cosines, which are the inverse lengths, is a half.
    CHECK(slot.mean_length == doctest::Approx(2).epsilon(0.05));
    for (const SurfaceLink& link : links) {
        REQUIRE(link.triangle >= 2);
        const glm::uvec3& corners = slot.triangles[link.triangle];
        const glm::vec3 end = (1 - link.b1 - link.b2) * slot.positions[corners.x] +
                              link.b1 * slot.positions[corners.y] + link.b2 * slot.positions[corners.z];
        const glm::vec3 way = glm::normalize(end - slot.positions[8]);
        CHECK(glm::length(way - directions.directions()[link.direction]) < 1e-3F);
    }
}

TEST_CASE("all links stand for what coarse links stand for, in parts of their strata") {
    const Slot slot;
    const DirectionSet directions(2048);
    const BakeGeometry geometry = slot.geometry();
    const Visibility visibility = bake(geometry, directions);
    const LinkSearch search(geometry, slot.sides, directions, visibility);
    std::vector<SurfaceLink> links;
    search.find(8, links);
    const std::vector<SurfaceLink> coarse = links;
    search.refine(8, links);
    CHECK(links.size() > 2 * coarse.size());
    CHECK(links.size() <= kPartsOfStratum * kLinkStrata);
    CHECK(solid_angle(links) == doctest::Approx(solid_angle(coarse)).epsilon(1e-5));
    for (std::size_t k = 0; k < links.size(); ++k) {
        CHECK(links[k].solid_angle > 0);
        if (k < coarse.size()) {
            CHECK(links[k].direction == coarse[k].direction);
            CHECK(links[k].coarse_solid_angle == coarse[k].solid_angle);
        } else {
            CHECK(links[k].coarse_solid_angle == 0);
        }
    }
}

TEST_CASE("links estimate the irradiance of a ceiling that emits 1 without bias, and all links better") {
    const Slot slot;
    const BakeGeometry geometry = slot.geometry();
    double all = 0, coarse = 0, all_error = 0, coarse_error = 0;
    constexpr int sets = 24;
    for (int set = 0; set < sets; ++set) {
        const DirectionSet directions(1024 + 64 * set);
        const Visibility visibility = bake(geometry, directions);
        const LinkSearch search(geometry, slot.sides, directions, visibility);
        std::vector<SurfaceLink> links;
        search.find(8, links);
        search.refine(8, links);
        double of_all = 0, of_coarse = 0;
        for (const SurfaceLink& link : links) {
            const double cosine = double{directions.directions()[link.direction].z} / std::numbers::pi;
            of_all += double{link.solid_angle} * cosine;
            of_coarse += double{link.coarse_solid_angle} * cosine;
        }
        all += of_all / sets;
        coarse += of_coarse / sets;
        all_error += (of_all - 1) * (of_all - 1);
        coarse_error += (of_coarse - 1) * (of_coarse - 1);
    }
    CHECK(all == doctest::Approx(1).epsilon(0.005));
    CHECK(coarse == doctest::Approx(1).epsilon(0.02));
    CHECK(all_error < coarse_error / 3);
}

TEST_CASE(
    "nothing leaves the back of a one-sided surface; that of a two-sided one has triangles of its own") {
    Slot slot;
    const DirectionSet directions(1024);
    for (glm::uvec3& triangle : {std::ref(slot.triangles[2]), std::ref(slot.triangles[3])})
        std::swap(triangle.y, triangle.z);
    CHECK(slot.links_of_middle(directions).empty());
    slot.triangles.emplace_back(4, 6, 5);
    slot.triangles.emplace_back(4, 7, 6);
    slot.sides.backs = {4, 5};
    const std::vector<SurfaceLink> links = slot.links_of_middle(directions);
    CHECK(solid_angle(links) == doctest::Approx(2 * std::numbers::pi).epsilon(0.03));
    for (const SurfaceLink& link : links) CHECK(link.triangle >= 4);
}
