// SPDX-License-Identifier: MIT
// Tests of high orders: lookups in floats against doubles.
#include <numeric>
#include <optional>

#include "material/chiral_material.hpp"
#include "material/conductor.hpp"
#include "specular/high_order_light.hpp"
#include "specular/high_order_visibility.hpp"
#include "specular/split_fit.hpp"
#include "stability/double_transfer.hpp"
#include "stability/lights.hpp"
#include "test.hpp"
#include "visibility/visibility_harmonics.hpp"

using namespace nicol;

namespace {

constexpr int low = 4;
constexpr int visibility_order = 9;

const DirectionSet& directions() {
    static const DirectionSet set(512);
    return set;
}

// Texture coordinates in floats are off by 2^-24 of the map's width, 1e-4 texels of the largest map. The
// field changes by a tenth of its size per texel.
constexpr double bound = 2e-5;

test::Deviation compare(const test::Vertices& vertices, const Material& material, const PshVector& light,
                        int high) {
    const std::size_t count = vertices.normals.size();
    const HighOrderFactors factors(material, SplitBasis(low, high), 3);
    HighOrderLight filtered(light, low, high, true);
    const HighOrderMaps maps = filtered.maps(factors);
    const glm::dmat3 rotation = frame_with_x(glm::normalize(glm::dvec3(1, -2, 0.5)), {0.3, 0.1, 1});
    const double width = kLobeWidths[static_cast<std::size_t>(factors.central_lobe())];

    const VisibilityHarmonics harmonics(directions(), visibility_order);
    VisibilityBlocks seen(vertices.visibility, visibility_order);
    const std::size_t blocks = (count + kLanes - 1) / kLanes, size = psh_count(visibility_order);
    std::vector<Lanes> lanes(blocks * size);
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0U);
    harmonics.project(vertices.visibility, vertices.normals, all, lanes);
    for (std::size_t first = 0; first < count; first += kLanes)
        seen.set(std::span(all).subspan(first, std::min(kLanes, count - first)),
                 &lanes[first / kLanes * size]);
    // The truth uses the stored coefficients, so that the loss of 16 bits does not count.
    std::vector<float> kept(psh_count(visibility_order));
    std::vector<glm::dvec2> fractions_truth;
    for (std::size_t v = 0; v < count; ++v) {
        seen.expand(v, kept);
        fractions_truth.push_back(test::fractions_in_double(
            vertices, v, std::vector<double>(kept.begin(), kept.end()), visibility_order, width));
    }
    const HighOrderVisibility fractions(visibility_order, width);

    std::vector<std::vector<glm::vec4>> found(3, std::vector<glm::vec4>(count, glm::vec4(0)));
    const std::vector<std::span<glm::vec4>> channels(found.begin(), found.end());
    HighOrder(factors, maps, rotation)
        .run(vertices.view, vertices.positions, vertices.normals, vertices.visible,
             {.fractions = {}, .visibility = &fractions, .seen = &seen}, 0, count, channels);
    return test::deviation(vertices, found,
                           test::high_orders_in_double(vertices, factors, maps, rotation, fractions_truth, 3),
                           bound);
}

}  // namespace

TEST_CASE("high orders: floats stay with doubles, under any light and at any size") {
    const MaterialPtr plastic = pplastic({.alpha = 0.1, .distribution = Distribution::ggx});
    const MaterialPtr gold =
        rough_conductor({.eta = metal_index("Au"), .alpha = 0.2, .distribution = Distribution::ggx});
    double worst = 0;
    const auto check = [&](const std::string& name, const test::Vertices& vertices,
                           const MaterialPtr& material, const PshVector& light, int high) {
        CAPTURES(name, high);
        const test::Deviation d = compare(vertices, *material, light, high);
        CHECK(d.finite);
        CHECK(d.largest > 0);
        CHECK(d.worst < bound);
        CHECK(d.negative == 0);
        worst = std::max(worst, d.worst);
    };
    const test::Vertices vertices(directions());
    for (const int high : {9, 32})
        for (const MaterialPtr& material : {plastic, gold, test::chiral(gold)})
            for (const auto& [name, light] : test::usual_lights(high))
                if (name != "even light") check(name, vertices, material, light, high);  // no high orders
    for (const auto& [name, light] : test::stress_lights(9)) check(name, vertices, plastic, light, 9);
    for (const double unit : {1e-6, 1e6})
        check("unit " + std::to_string(unit), test::Vertices(directions(), unit), plastic,
              test::random_light(9, 3, 4, 1), 9);
    MESSAGE("high orders: worst " << worst << " of the largest value");
}
