// SPDX-License-Identifier: MIT
#include "specular/high_order.hpp"

#include "directions.hpp"
#include "harmonics/order_gains.hpp"
#include "material/brute_force.hpp"
#include "specular/high_order_light.hpp"
#include "specular/high_order_scene.hpp"
#include "specular/split_fit.hpp"
#include "test.hpp"

using namespace nicol;
using test::gold;
using test::plastic;

namespace {

constexpr int l_low = 4;

}  // namespace

TEST_CASE("unpolarized light has the same look-up in maps of either kind") {
    const PshVector light = test::random_light(20, 5, 1, 2);
    const test::SphereView sphere(4, 5);
    const HighOrderFactors factors(*pplastic({.alpha = 0.2}), SplitBasis(l_low, 20), 5);
    HighOrderLight plain(light, l_low, 20, false);
    HighOrderLight full(light, l_low, 20, true);
    const auto black = sphere.black(5);
    const auto a = sphere.with(black, HighOrder(factors, plain.maps(factors), glm::dmat3(1.0)));
    const auto b = sphere.with(black, HighOrder(factors, full.maps(factors), glm::dmat3(1.0)));
    float largest = 0;
    float difference = 0;
    for (std::size_t c = 0; c < a.size(); ++c) {
        for (std::size_t v = 0; v < a[c].size(); ++v) {
            largest = std::max(largest, std::abs(a[c][v][0]));
            difference = std::max(difference, glm::distance(a[c][v], b[c][v]));
        }
    }
    CHECK(difference < 1e-5F * largest);
    CHECK(full.bytes() == 5 * plain.bytes());
    // One light serves materials of several colours.
    const HighOrderFactors coloured(*gold(0.2), SplitBasis(l_low, 20), 3);
    HighOrderLight grey(test::random_light(20, 1, 1, 2), l_low, 20, false);
    const auto c = sphere.with(sphere.black(3), HighOrder(coloured, grey.maps(coloured), glm::dmat3(1.0)));
    CHECK(c[0] != c[2]);
}

TEST_CASE("shadows dim the lobe and the base, vertices that are not visible are left alone") {
    const PshVector light = test::random_light(12, 1, 1, 4);
    const HighOrderFactors factors(*pplastic({.alpha = 0.2}), SplitBasis(l_low, 12), 1);
    HighOrderLight filtered(light, l_low, 12, false);
    const HighOrder high(factors, filtered.maps(factors), glm::dmat3(1.0));
    Viewpoint view;
    view.orthographic = true;
    const glm::vec3 normal = glm::normalize(glm::vec3(0.4F, 0.2F, -1));
    const auto look = [&](const glm::vec2& fraction) {
        return test::look_up(high, view, normal, fraction, 1)[0];
    };
    const glm::vec4 open = look({1, 1});
    CHECK(glm::length(open) > 0);
    CHECK(look({0, 0}) == glm::vec4(0));
    CHECK(glm::distance(look({0.25F, 0}) + look({0.75F, 1}), open) < 1e-6F);

    std::vector<glm::vec4> out(3, glm::vec4(5));
    const std::vector<std::span<glm::vec4>> channels{out};
    const std::vector<glm::vec3> normals(3, normal);
    const std::vector<glm::vec3> positions(3, glm::vec3(0));
    const std::vector<std::uint8_t> visible{1, 0, 1};
    const std::vector<glm::vec2> fractions{{1, 1}, {1, 1}, {0, 0}};
    high.run(view, positions, normals, visible, {.fractions = fractions}, 0, 3, channels);
    CHECK(glm::distance(out[0], glm::vec4(5) + open) < 1e-6F);
    CHECK(out[1] == glm::vec4(5));
    CHECK(out[2] == glm::vec4(5));
}

TEST_CASE("maps and channels must fit") {
    const PshVector light = test::random_light(6, 2, 1, 4);
    const HighOrderFactors factors(*gold(0.3), SplitBasis(l_low, 6), 3);
    HighOrderLight two(light, l_low, 6, false);
    CHECK_THROWS_AS(HighOrder(factors, two.maps(factors), glm::dmat3(1.0)), Error);
    HighOrderLight one(test::random_light(6, 1, 1, 4), l_low, 6, false);
    HighOrderMaps maps = one.maps(factors);
    CHECK_NOTHROW(HighOrder(factors, maps, glm::dmat3(1.0)));
    maps.outer = nullptr;
    CHECK_THROWS_AS(HighOrder(factors, maps, glm::dmat3(1.0)), Error);
    maps = one.maps(factors);
    const LobeMap polarized(light, gaussian_gains(0.1, 5, 6), true);
    maps.base = &polarized;
    CHECK_THROWS_AS(HighOrder(factors, maps, glm::dmat3(1.0)), Error);
    CHECK_THROWS_AS(HighOrder(factors, {}, glm::dmat3(1.0)), Error);
    CHECK_THROWS_AS(HighOrderLight(light, 6, 6, false), Error);
    CHECK_THROWS_AS(convolved_map(light, std::vector<ConvolutionKernel>(3, ConvolutionKernel(7)), 4, 6),
                    Error);
    CHECK_THROWS_AS(convolved_map(light, std::vector<ConvolutionKernel>(1, ConvolutionKernel(5)), 4, 6),
                    Error);
}
