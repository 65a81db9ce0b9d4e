// SPDX-License-Identifier: MIT
#include "surfaces/equal_materials.hpp"

#include "render/scenes.hpp"
#include "render/textured.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

MaterialPtr plastic(double alpha) {
    return pplastic({.diffuse_reflectance = {0.2, 0.4, 0.6}, .alpha = alpha});
}

}  // namespace

TEST_CASE("materials with equal values are one, and no others") {
    const auto own = [](const MaterialPtr& material) { return scaled(material, test::flat_normals()); };
    struct Case {
        const char* what;
        MaterialPtr one, other;
        bool equal;
    };
    for (const Case& c : {Case{"equal parameters", plastic(0.3), plastic(0.3), true},
                          {"another roughness", plastic(0.3), plastic(0.3000001), false},
                          {"another kind", plastic(0.3), diffuse({0.5}), false},
                          {"another number of channels", diffuse({0.5}), diffuse({0.5, 0.5, 0.5}), false},
                          {"one of two sides", diffuse({0.5}), twosided(diffuse({0.5})), false},
                          {"both of two sides", twosided(plastic(0.2)), twosided(plastic(0.2)), true},
                          {"textures", own(plastic(0.3)), own(plastic(0.3)), false}}) {
        CAPTURE(c.what);
        EqualMaterials materials;
        CHECK(materials.first_of(c.one) == c.one);
        CHECK((materials.first_of(c.other) == c.one) == c.equal);
        CHECK(materials.first_of(c.one) == c.one);
    }
}

TEST_CASE("a first material is kept as long as it or an equal one is asked for") {
    EqualMaterials materials;
    const MaterialPtr first = plastic(0.3), second = plastic(0.3), third = plastic(0.3);
    CHECK(materials.first_of(first) == first);
    materials.forget_unused();
    CHECK(materials.first_of(second) == first);
    materials.forget_unused();
    CHECK(materials.first_of(second) == first);
    materials.forget_unused();
    CHECK(first.use_count() > 1);
    materials.forget_unused();
    CHECK(first.use_count() == 1);
    CHECK(materials.first_of(third) == third);
}
