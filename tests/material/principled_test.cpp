// SPDX-License-Identifier: MIT
#include "material/principled.hpp"

#include "directions.hpp"
#include "error.hpp"
#include "function_texture.hpp"
#include "matrix_at.hpp"
#include "test.hpp"

using namespace nicol;
using doctest::Approx;
using test::matrix_at;

namespace {

TexturePtr board(float color0, float color1, double scale) {
    return checkerboard_texture(glm::vec3(color0), glm::vec3(color1), 1,
                                glm::dmat3(scale, 0, 0, 0, scale, 0, 0, 0, 1));
}

TexturePtr constant(double value) {
    return constant_texture(glm::vec4(static_cast<float>(value)), 1);
}

/// A numeric parameter. The list below contains all but eta.
struct Number {
    const char* name;
    NumberParameter PrincipledParameters::*parameter;
};
const Number kNumbers[] = {{"roughness", &PrincipledParameters::roughness},
                           {"anisotropic", &PrincipledParameters::anisotropic},
                           {"metallic", &PrincipledParameters::metallic},
                           {"spec_trans", &PrincipledParameters::spec_trans},
                           {"spec_tint", &PrincipledParameters::spec_tint},
                           {"sheen", &PrincipledParameters::sheen},
                           {"sheen_tint", &PrincipledParameters::sheen_tint},
                           {"flatness", &PrincipledParameters::flatness},
                           {"clearcoat", &PrincipledParameters::clearcoat},
                           {"clearcoat_gloss", &PrincipledParameters::clearcoat_gloss}};

}  // namespace

TEST_CASE("values of Mitsuba 3's principled") {
    // Values of Mitsuba 3.9.1, scalar_rgb: load_dict({'type': 'principled', 'base_color': (0.2, 0.8, 0.1),
    // ...}) .eval(BSDFContext(), si, wo), which includes the cosine of wo. The first pair is si.wi along
    // (-0.45, 0.3, 0.8) and wo along (0.5, -0.2, 0.8), the second (0.9, 0.1, 0.25) and (-0.6, 0.5, 0.4).
    const std::pair<glm::dvec3, glm::dvec3> pairs[] = {{{-0.45, 0.3, 0.8}, {0.5, -0.2, 0.8}},
                                                       {{0.9, 0.1, 0.25}, {-0.6, 0.5, 0.4}}};
    struct Case {
        const char* name;
        PrincipledParameters parameters;
        std::array<std::array<double, 3>, 2> expected;
    };
    const Case cases[] = {
        {"defaults", {}, {{{0.1089049, 0.2673482, 0.08249763}, {0.03170176, 0.1134442, 0.01807803}}}},
        {"rough",
         {.roughness = 0.9, .eta = index_of_specular(0.8)},
         {{{0.0613554, 0.2198244, 0.0349439}, {0.03973387, 0.1262086, 0.02532141}}}},
        {"glossy",
         {.roughness = 0.2, .eta = 1.8},
         {{{0.3658804, 0.5243046, 0.3394763}, {0.0263235, 0.1045682, 0.01328271}}}},
        {"metal",
         {.roughness = 0.3, .metallic = 1},
         {{{0.9312067, 3.722903, 0.4659238}, {0.002003402, 0.007273548, 0.001125044}}}},
        {"half a metal",
         {.roughness = 0.4, .metallic = 0.5, .eta = index_of_specular(0.3)},
         {{{0.3268255, 1.203044, 0.1807889}, {0.01710027, 0.06492871, 0.009128866}}}},
        {"tinted",
         {.roughness = 0.4, .eta = 1.9, .spec_tint = 0.7},
         {{{0.189961, 0.5212083, 0.1347532}, {0.02901474, 0.1112218, 0.01531357}}}},
        {"sheen",
         {.sheen = 0.8},
         {{{0.1089963, 0.2674397, 0.08258905}, {0.04166383, 0.1234063, 0.02804009}}}},
        {"tinted sheen",
         {.metallic = 0.2, .sheen = 0.8, .sheen_tint = 0.6},
         {{{0.1398585, 0.4246204, 0.09239817}, {0.03241097, 0.1085316, 0.0197242}}}},
        {"flat",
         {.roughness = 0.7, .flatness = 0.8},
         {{{0.05810153, 0.1853473, 0.0368939}, {0.04917657, 0.1707269, 0.02891818}}}},
        {"clearcoat",
         {.clearcoat = 0.9, .clearcoat_gloss = 0.3},
         {{{0.153971, 0.3124143, 0.1275638}, {0.0323448, 0.1140872, 0.01872106}}}},
        {"partly transparent",
         {.spec_trans = 0.6, .flatness = 0.3},
         {{{0.07565615, 0.1343534, 0.06587327}, {0.01727068, 0.05571987, 0.01086249}}}},
        {"index below 1",
         {.metallic = 0.4, .eta = 0.8, .spec_tint = 0.5, .clearcoat = 0.5},
         {{{0.1665606, 0.58174, 0.09736405}, {0.07487974, 0.1239252, 0.06670549}}}},
        {"no facets",
         {.metallic = 0.6, .eta = index_of_specular(0)},
         {{{0.02112578, 0.08450312, 0.01056289}, {0.01089899, 0.04359596, 0.005449495}}}},
        {"brushed",
         {.roughness = 0.5, .anisotropic = 0.8, .metallic = 0.7},
         {{{0.1675589, 0.6318919, 0.09017009}, {0.008967231, 0.03528163, 0.004581498}}}},
        {"brushed and glossy",
         {.roughness = 0.3, .anisotropic = 0.4, .clearcoat = 0.5},
         {{{0.2241288, 0.3825593, 0.1977237}, {0.0272471, 0.1066528, 0.01401282}}}},
        {"everything",
         {.roughness = 0.35,
          .metallic = 0.3,
          .spec_trans = 0.2,
          .eta = index_of_specular(0.6),
          .spec_tint = 0.4,
          .sheen = 0.5,
          .sheen_tint = 0.5,
          .flatness = 0.4,
          .clearcoat = 0.7,
          .clearcoat_gloss = 0.6},
         {{{0.384931, 1.172544, 0.2536621}, {0.0237702, 0.08460631, 0.01363085}}}}};
    for (const Case& row : cases) {
        PrincipledParameters parameters = row.parameters;
        parameters.base_color = {0.2, 0.8, 0.1};
        const MaterialPtr material = principled(parameters);
        for (std::size_t i = 0; i < 2; ++i) {
            CAPTURES(row.name, i);
            const glm::dvec3 viewer = glm::normalize(pairs[i].first);
            const glm::dvec3 light = glm::normalize(pairs[i].second);
            for (int c = 0; c < 3; ++c) {
                const Mueller m = evaluate(*material, c, light, viewer);
                CHECK(m(0, 0) * light.z ==
                      Approx(row.expected[i][static_cast<std::size_t>(c)]).epsilon(2e-5));
                // The material depolarizes.
                for (std::size_t e = 1; e < 16; ++e) CHECK(m(e / 4, e % 4) == 0);
            }
        }
    }
}

TEST_CASE("the facets of a principled material are what depends on the azimuth") {
    const PrincipledParameters brushed{.anisotropic = 0.5, .clearcoat = 1};
    PrincipledParameters plain = brushed;
    plain.anisotropic = 0;
    CHECK(principled(brushed)->anisotropic());
    CHECK(principled(brushed)->isotropic().content_key() == principled(plain)->content_key());
    CHECK(principled(brushed)->content_key() != principled(plain)->content_key());
    PrincipledParameters without_facets = brushed;
    without_facets.eta = 1;
    CHECK_FALSE(principled(without_facets)->anisotropic());
}

TEST_CASE("a black base has white tints") {
    const PrincipledParameters black{.base_color = {0, 0, 0}, .spec_tint = 1, .sheen = 1, .sheen_tint = 1};
    PrincipledParameters grey = black;
    grey.base_color = {0};
    grey.sheen_tint = 0;
    const glm::dvec3 light = direction(1, 0), viewer = direction(0.8, 2);
    CHECK(evaluate(*principled(black), 1, light, viewer)(0, 0) ==
          Approx(evaluate(*principled(grey), 0, light, viewer)(0, 0)));
    CHECK(evaluate(*principled(black), 1, light, viewer)(0, 0) > 0.004);
}

TEST_CASE("nothing to reflect is black") {
    CHECK(largest(evaluate(*principled({.metallic = 1, .eta = 1}), 0, direction(1, 0), direction(0.5, 1))) ==
          0);
}

TEST_CASE("principled textures of one value are numbers") {
    PrincipledParameters numbers{.base_color = {0.3, 0.6, 0.8}};
    PrincipledParameters textures{.base_color = constant_texture({0.3F, 0.6F, 0.8F, 1}, 3)};
    double value = 0.15;
    for (const Number& n : kNumbers) {
        numbers.*n.parameter = value += 0.0625;
        textures.*n.parameter = constant(value);
    }
    const MaterialPtr expected = principled(numbers);
    const MaterialPtr found = principled(textures);
    CHECK(found->variation() == nullptr);
    CHECK(found->channels() == 3);
    for (int c = 0; c < 3; ++c)
        CHECK(evaluate(*found, c, direction(0.4, 1), direction(0.7, 3.9))(0, 0) ==
              Approx(evaluate(*expected, c, direction(0.4, 1), direction(0.7, 3.9))(0, 0)).epsilon(1e-6));
    // Texture values outside 0 to 1 are clamped.
    CHECK(principled({.sheen = constant(7)})->content_key() == principled({.sheen = 1})->content_key());
}

TEST_CASE("where its textures have a value, a principled material is the one of that value") {
    const TexturePtr colors = checkerboard_texture({0.2F, 0.8F, 0.1F}, {0.9F, 0.3F, 0.5F}, 3,
                                                   glm::dmat3(0.7, 0, 0, 0, 0.7, 0, 0, 0, 1));
    const PrincipledParameters all{.base_color = {0.2, 0.5, 0.3},
                                   .roughness = 0.4,
                                   .metallic = 0.3,
                                   .spec_trans = 0.2,
                                   .spec_tint = 0.4,
                                   .sheen = 0.5,
                                   .sheen_tint = 0.5,
                                   .flatness = 0.4,
                                   .clearcoat = 0.7,
                                   .clearcoat_gloss = 0.6};
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0, 1);
    const auto check = [&](const PrincipledParameters& varying) {
        const MaterialPtr material = principled(varying);
        REQUIRE(material->variation() != nullptr);
        for (int i = 0; i < 20; ++i) {
            const TexturePoint point{.uv = {unit(random), unit(random)}};
            PrincipledParameters there = all;
            for (const Number& n : kNumbers)
                if (const TexturePtr& texture = (varying.*n.parameter).texture)
                    there.*n.parameter = static_cast<double>(texture->at(point).x);
            if (const TexturePtr& texture = varying.base_color.texture) {
                const glm::vec4 color = texture->at(point);
                there.base_color = {color.x, color.y, color.z};
            }
            const glm::dvec3 light = random_direction_within(random, 1.5);
            const glm::dvec3 viewer = random_direction_within(random, 1.5);
            for (int c = 0; c < 3; ++c)
                CHECK(matrix_at(*material, c, point.uv, light, viewer)(0, 0) ==
                      Approx(evaluate(*principled(there), c, light, viewer)(0, 0)).epsilon(1e-5));
        }
    };
    PrincipledParameters together = all;
    together.base_color = colors;
    check(together);
    double scale = 0.5;
    for (const Number& n : kNumbers) {
        CAPTURE(n.name);
        PrincipledParameters alone = all;
        alone.*n.parameter = together.*n.parameter = board(0.2F, 0.9F, scale += 0.35);
        check(alone);
    }
    check(together);
}

TEST_CASE("a principled material has as few layers as its textures allow") {
    const auto layers = [](const PrincipledParameters& parameters) {
        const MaterialPtr material = principled(parameters);
        return material->variation() == nullptr ? 1 : material->variation()->layers.size();
    };
    const TexturePtr a = board(0.2F, 0.7F, 1), b = board(0.3F, 0.8F, 2);
    const TexturePtr colors = checkerboard_texture(glm::vec3(0.2F, 0.8F, 0.1F), glm::vec3(1), 3);
    CHECK(layers({}) == 1);
    // One layer is coloured and one white.
    CHECK(layers({.base_color = colors}) == 2);
    // There is one layer for each roughness.
    CHECK(layers({.roughness = a}) == 2);
    CHECK(layers({.roughness = a, .sheen = 1, .clearcoat = 1}) == 3);
    // Metal and the rest are separate layers.
    CHECK(layers({.metallic = a, .spec_tint = 0.5, .sheen = 1}) == 2);
    CHECK(layers({.metallic = a, .sheen = 1, .clearcoat = b}) == 3);
    // Textures without effect, because another parameter is 0 or 1, add no layers.
    CHECK(layers({.sheen_tint = a, .clearcoat_gloss = b}) == 1);
    CHECK(layers({.metallic = 1, .spec_trans = a, .spec_tint = a, .sheen = b, .flatness = b}) == 1);
}

TEST_CASE("principled parameters out of range are named") {
    const auto bad = ErrorCode::invalid_argument;
    for (const Number& n : kNumbers) {
        for (const double value : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
            PrincipledParameters parameters;
            parameters.*n.parameter = value;
            check_error(bad, CALL(principled(parameters)), n.name);
        }
    }
    check_error(bad, CALL(principled({.base_color = {}})), "base_color");
    check_error(bad, CALL(principled({.base_color = {1.5}})), "base_color");
    check_error(bad, CALL(principled({.eta = 0})), "eta");
    check_error(bad, CALL(principled({.eta = -1.5})), "eta");
    check_error(ErrorCode::unsupported,
                CALL(principled({.base_color = mesh_color_texture(ColorsOf::vertices), .spec_tint = 1})),
                "tint");
    CHECK(principled({.base_color = mesh_color_texture(ColorsOf::vertices)})->variation() != nullptr);
}
