// SPDX-License-Identifier: MIT
#include "material/clearcoat.hpp"

#include "directions.hpp"
#include "function_texture.hpp"
#include "material/conductor.hpp"
#include "material/dielectric.hpp"
#include "material/mixed_terms.hpp"
#include "material/mixture.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("a coated diffuse material is pplastic") {
    const MaterialPtr coated = clearcoat(diffuse({0.3, 0.5, 0.7}), {.alpha = 0.2, .eta = 1.5});
    const MaterialPtr plastic = pplastic({.diffuse_reflectance = {0.3, 0.5, 0.7},
                                          .int_ior = 1.5,
                                          .ext_ior = 1,
                                          .alpha = 0.2,
                                          .distribution = Distribution::ggx});
    std::mt19937 random(3);
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 light = random_direction_within(random, 1.5);
        const glm::dvec3 viewer = random_direction_within(random, 1.5);
        for (int c = 0; c < 3; ++c) {
            const Mueller expected = evaluate(*plastic, c, light, viewer);
            CHECK(largest_difference(evaluate(*coated, c, light, viewer), expected) <= 1e-12);
        }
        CHECK(evaluate(*coated, 0, -light, viewer)(0, 0) == 0);
    }
}

TEST_CASE("a share of a coat is a blend, none is the material, and layers of textures are coated") {
    const MaterialPtr metal = rough_conductor({.eta = metal_index("Au"), .alpha = 0.3});
    const MaterialPtr coated = clearcoat(metal, {.alpha = 0.1});
    CHECK(clearcoat(metal, {.factor = 0.0}) == metal);
    const MaterialPtr partly = clearcoat(metal, {.factor = 0.25, .alpha = 0.1});
    const glm::dvec3 light = direction(0.5, 1), viewer = direction(0.7, 3);
    const auto s0 = [&](const MaterialPtr& of) { return evaluate(*of, 1, light, viewer)(0, 0); };
    CHECK(s0(partly) == doctest::Approx(0.75 * s0(metal) + 0.25 * s0(coated)));

    const TexturePtr squares =
        test::texture_of([](const TexturePoint& at) { return glm::vec4(at.uv.x < 0.5F ? 0.8F : 0.2F); }, 1);
    const MaterialPtr varied = clearcoat(scaled(metal, squares), {.alpha = 0.1});
    REQUIRE(varied->variation() != nullptr);
    CHECK(varied->variation()->layers.size() == 2);
}

TEST_CASE("coats of nothing, of glass and out of range are refused") {
    const MaterialPtr grey = diffuse({0.5});
    CHECK_INVALID(clearcoat(nullptr, {}));
    CHECK_INVALID(clearcoat(dielectric({}), {}));
    CHECK_INVALID(clearcoat(twosided(grey), {}));
    CHECK_INVALID(clearcoat(grey, {.factor = 1.5}));
    CHECK_INVALID(clearcoat(grey, {.eta = 0}));
    CHECK_INVALID(clearcoat(grey, {.alpha = 2}));
}

TEST_CASE("terms that reflect light beside their lobes are known below coats and in mixtures") {
    const MaterialPtr metal = rough_conductor({.eta = metal_index("Au"), .alpha = 0.2});
    const MaterialPtr function = callback_material({.reflect =
                                                        [](int, const glm::dvec3&, const glm::dvec3&) {
                                                            Mueller out;
                                                            out(0, 0) = 0.2;
                                                            return out;
                                                        },
                                                    .lobe_width = 0.2});
    const struct {
        MaterialPtr material;
        bool mixed;
    } rows[] = {{metal, false},
                {function, true},
                {twosided(metal), false},
                {twosided(function), true},
                {sum(metal, metal), false},
                {sum(function, metal), true},
                {clearcoat(metal, {.alpha = 0.1}), false},
                {clearcoat(function, {.alpha = 0.1}), true}};
    for (const auto& row : rows) {
        CHECK(is_mixed(*row.material, 0) == row.mixed);
        const int last = row.material->terms() - 1;
        CHECK(is_mixed(*row.material, last) == (row.mixed && last == 0));
    }
}
