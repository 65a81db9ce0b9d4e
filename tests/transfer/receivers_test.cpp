// SPDX-License-Identifier: MIT
// Tests of the choice of receivers of bounced light.
#include "transfer/receivers.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>

#include "visibility/hidden_light.hpp"

using namespace nicol;

namespace {

constexpr std::uint32_t kSide = 41;  // vertices along a side of each plate

// Plates of side 4: the floor z = 0 and the wall x = 0, which meet, and a floor far away that sees nothing.
struct Corner {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::uvec3> triangles;
    TriangleSides sides;

    // bent: whether neighbours have unlike normals, so that receivers serve few vertices.
    explicit Corner(bool bent) {
        add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
        add({0, 0, 0}, {0, 1, 0}, {0, 0, 1});
        add({100, 0, 0}, {1, 0, 0}, {0, 1, 0});
        sides.fronts.resize(triangles.size());
        std::iota(sides.fronts.begin(), sides.fronts.end(), 0U);
        for (std::size_t v = 0; bent && v < normals.size(); ++v) {
            const auto angle = static_cast<float>(v);
            normals[v] = glm::normalize(normals[v] + 0.6F * glm::vec3(std::cos(angle), std::sin(angle), 0));
        }
    }
    void add(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v) {
        const auto first = static_cast<std::uint32_t>(positions.size());
        for (std::uint32_t i = 0; i < kSide; ++i)
            for (std::uint32_t j = 0; j < kSide; ++j) {
                const float step = 4.0F / (kSide - 1);
                positions.push_back(corner + step * static_cast<float>(i) * u +
                                    step * static_cast<float>(j) * v);
                normals.push_back(glm::cross(u, v));
                if (i + 1 == kSide || j + 1 == kSide) continue;
                const std::uint32_t at = first + i * kSide + j;
                triangles.emplace_back(at, at + kSide, at + kSide + 1);
                triangles.emplace_back(at, at + kSide + 1, at + 1);
            }
    }
    [[nodiscard]] BakeGeometry geometry() const {
        return {.positions = positions, .normals = normals, .triangles = triangles};
    }
};

struct Chosen {
    explicit Chosen(bool bent = false) : corner(bent) {}

    Corner corner;
    DirectionSet directions{1024};
    BakeGeometry geometry = corner.geometry();
    Visibility visibility = bake(geometry, directions);
    LinkSearch search{geometry, corner.sides, directions, visibility};
    Receivers receivers = find_receivers(geometry, search, visibility);
};

}  // namespace

TEST_CASE("receivers are few, and denser near other surfaces") {
    const Chosen chosen;
    const std::size_t plate = std::size_t{kSide} * kSide;
    CHECK(chosen.receivers.vertices.size() < plate / 3);
    std::size_t near = 0, far = 0;  // receivers of the floor
    for (const std::uint32_t v : chosen.receivers.vertices) {
        CHECK(v < 2 * plate);
        if (v < plate) ++(chosen.corner.positions[v].x < 2 ? near : far);
    }
    CHECK(near > 2 * far);
    CHECK(far > 0);
}

TEST_CASE("vertices blend receivers of their own surface that are near, and see about as much of others") {
    const Chosen chosen;
    const Receivers& receivers = chosen.receivers;
    const HiddenLight hidden(chosen.directions);
    const auto hidden_at = [&](std::uint32_t v) {
        return hidden.at(chosen.visibility, v, chosen.corner.normals[v]);
    };
    std::map<std::uint32_t, float> lengths;
    std::vector<SurfaceLink> links;
    for (const std::uint32_t v : receivers.vertices) lengths[v] = chosen.search.find(v, links);
    std::size_t exact = 0;
    for (std::uint32_t v = 0; v < receivers.blends.size(); ++v) {
        const Receivers::Blend& blend = receivers.blends[v];
        const float sum = std::accumulate(blend.weights.begin(), blend.weights.end(), 0.0F);
        if (chosen.visibility.unoccluded(v)) {
            CHECK(sum == 0);
            continue;
        }
        CHECK(sum == doctest::Approx(1));
        for (std::size_t k = 0; k < blend.weights.size(); ++k) {
            if (blend.weights[k] == 0) continue;
            CHECK(blend.weights[k] > 0);
            const std::uint32_t from = receivers.vertices[blend.receivers[k]];
            const float distance = glm::length(chosen.corner.positions[v] - chosen.corner.positions[from]);
            const glm::vec4 seen = hidden_at(v), seen_from = hidden_at(from);
            const double unlike =
                HiddenLight::magnitude(seen - seen_from) / double{std::max(seen.x, seen_from.x) + 0.05F};
            CHECK(double{distance} / (0.3 * double{lengths[from]}) + 2 * unlike <= 1.001);
            CHECK(chosen.corner.normals[v] == chosen.corner.normals[from]);
            if (from == v) ++exact;
        }
    }
    CHECK(exact > 0);
}

TEST_CASE("links belong to their receivers, in order") {
    bool bent = false;
    SUBCASE("few receivers") {}
    // The choice begins again with a larger reach, and takes over links.
    SUBCASE("more receivers than there may be") {
        bent = true;
    }
    const Chosen chosen(bent);
    const Receivers& receivers = chosen.receivers;
    constexpr std::size_t few = 2048;
    // The limit goes after the last growth.
    CHECK(receivers.vertices.size() <= (bent ? chosen.geometry.positions.size() / 2 : few));
    if (bent) CHECK(receivers.vertices.size() > few / 4);
    std::vector<SurfaceLink> own;
    std::size_t k = 0;
    for (std::uint32_t r = 0; r < receivers.vertices.size(); ++r) {
        chosen.search.find(receivers.vertices[r], own);
        CHECK(!own.empty());
        chosen.search.refine(receivers.vertices[r], own);
        for (const SurfaceLink& link : own) {
            REQUIRE(k < receivers.links.size());
            CHECK(receivers.links[k].receiver == r);
            CHECK(receivers.links[k++].direction == link.direction);
        }
    }
    CHECK(k == receivers.links.size());
}
