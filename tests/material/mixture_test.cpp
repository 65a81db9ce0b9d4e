// SPDX-License-Identifier: MIT
#include "material/mixture.hpp"

#include "directions.hpp"
#include "error.hpp"
#include "function_texture.hpp"
#include "material/conductor.hpp"
#include "material/principled.hpp"
#include "material/response_table.hpp"
#include "matrix_at.hpp"
#include "test.hpp"

using namespace nicol;
using doctest::Approx;
using test::matrix_at;
using test::texture_of;

namespace {

/// Returns a texture of value u in every channel.
TexturePtr ramp_texture() {
    return texture_of([](const TexturePoint& p) { return glm::vec4(p.uv.x, p.uv.x, p.uv.x, 1); }, 1);
}

MaterialPtr gloss(double alpha) {
    return pplastic({.diffuse_reflectance = {0}, .specular_reflectance = {1}, .alpha = alpha});
}

}  // namespace

TEST_CASE("materials of others and textures are what their names say at every point") {
    const MaterialPtr red = diffuse({0.8, 0.1, 0.1});
    const MaterialPtr metal =
        rough_conductor({.eta = {{0.2, -3.2}}, .alpha = 0.3, .distribution = Distribution::ggx});
    const TexturePtr u = ramp_texture();
    const TexturePtr colour =
        texture_of([](const TexturePoint& p) { return glm::vec4(p.uv.x, p.uv.y, 0.25F, 1); }, 3);
    const TexturePtr rough = texture_of([](const TexturePoint& p) { return glm::vec4(0.1F + 0.4F * p.uv.x); },
                                        1, glm::vec2(0.1F, 0.5F));
    using Expected = std::function<Mueller(int, glm::vec2, const glm::dvec3&, const glm::dvec3&)>;
    const struct {
        const char* name;
        MaterialPtr material;
        Expected expected;
        double tolerance;
    } rows[] = {
        {"scaled", scaled(red, colour),
         [&](int c, glm::vec2 uv, auto& l, auto& v) {
             return static_cast<double>((*colour).at({.uv = uv})[c]) * evaluate(*red, c, l, v);
         },
         1e-7},
        {"blend", blend(red, metal, u),
         [&](int c, glm::vec2 uv, auto& l, auto& v) {
             return (1.0 - static_cast<double>(uv.x)) * evaluate(*red, c, l, v) +
                    static_cast<double>(uv.x) * evaluate(*metal, c, l, v);
         },
         1e-6},
        {"sum of a scaled blend", sum(scaled(blend(red, metal, u), colour), metal),
         [&](int c, glm::vec2 uv, auto& l, auto& v) {
             const double x = static_cast<double>(uv.x);
             const Mueller mixed = (1.0 - x) * evaluate(*red, c, l, v) + x * evaluate(*metal, c, l, v);
             return static_cast<double>((*colour).at({.uv = uv})[c]) * mixed + evaluate(*metal, c, l, v);
         },
         1e-6},
        {"roughness", with_roughness(gloss, rough),
         [&](int c, glm::vec2 uv, auto& l, auto& v) {
             return evaluate(*gloss(0.1 + 0.4 * static_cast<double>(uv.x)), c, l, v);
         },
         0.15},  // in the tail of a lobe; numbers of a texture are as few as its mean error allows
        {"two-sided", twosided(blend(red, metal, u)),
         [&](int c, glm::vec2 uv, auto& l, auto& v) {
             return (1.0 - static_cast<double>(uv.x)) * evaluate(*red, c, l, v) +
                    static_cast<double>(uv.x) * evaluate(*metal, c, l, v);
         },
         1e-6}};
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(0, 1);
    for (const auto& row : rows) {
        CAPTURE(row.name);
        REQUIRE(row.material->variation() != nullptr);
        CHECK(row.material->variation()->needs_texcoords());
        for (int i = 0; i < 50; ++i) {
            const glm::vec2 uv(unit(random), unit(random));
            const glm::dvec3 light = random_direction_within(random, 1.4);
            const glm::dvec3 viewer = random_direction_within(random, 1.4);
            for (int c = 0; c < row.material->channels(); ++c) {
                const Mueller expected = row.expected(c, uv, light, viewer);
                CHECK(largest_difference(matrix_at(*row.material, c, uv, light, viewer), expected) <=
                      row.tolerance * std::max(expected(0, 0), 0.01));
            }
        }
    }
    CHECK(twosided(blend(red, metal, u))->twosided());
}

TEST_CASE("sixteen points have the weights that each of them has") {
    const TexturePtr u = ramp_texture();
    const TexturePtr colour =
        texture_of([](const TexturePoint& p) { return glm::vec4(p.uv.x, 0.3F, -p.uv.y, 1); }, 3);
    const TexturePtr few = texture_of(
        [](const TexturePoint& p) { return glm::vec4(p.uv.x > 0.9F ? 0.45F : 0.1F * std::ceil(5 * p.uv.x)); },
        1, glm::vec2(0.1F, 0.5F));
    const MaterialPtr red = diffuse({0.8, 0.1, 0.1});
    for (const MaterialPtr& material :
         {with_roughness(gloss, u), with_roughness(gloss, few), blend(red, gloss(0.2), u), scaled(red, u),
          scaled_again(red, colour, 0.6), scaled(blend(red, with_roughness(gloss, few), u), colour)}) {
        const SpatialVariation& variation = *material->variation();
        const std::size_t layers = variation.layers.size();
        // Points over the whole texture and beyond it, closely spaced points, and a single point.
        for (const auto& [first, step] : {std::pair{-0.1F, 0.08F}, {0.2F, 0.01F}, {0.3F, 0.0F}}) {
            CAPTURES(layers, first);
            TexturePoints points{};
            for (std::size_t i = 0; i < kLanes; ++i) {
                points.uv[0][i] = first + step * static_cast<float>(i);
                points.uv[1][i] = 0.7F * static_cast<float>(i);
            }
            std::vector<LayerWeights> found(layers);
            variation.weights(points, found);
            std::vector<glm::vec3> expected(layers);
            for (std::size_t i = 0; i < kLanes; ++i) {
                variation.weights({.uv = {points.uv[0][i], points.uv[1][i]}}, expected);
                for (std::size_t l = 0; l < layers; ++l) {
                    glm::vec3 weight(0);
                    const bool any = (found[l].points >> i & 1) != 0;
                    for (glm::length_t c = 0; c < 3 && found[l].points != 0; ++c)
                        weight[c] = found[l].of(static_cast<std::size_t>(c))[i];
                    CHECK(any == (weight != glm::vec3(0)));
                    CHECK(glm::length(weight - expected[l]) < 1e-5F);
                }
            }
        }
    }
}

TEST_CASE("roughness of two textures, one for each direction") {
    const auto brushed = [](double u, double v) {
        return rough_conductor(
            {.eta = {{0.2, -3.2}}, .alpha = u, .alpha_v = v, .distribution = Distribution::ggx});
    };
    const glm::dvec3 light = direction(0.6, 0.3);
    const glm::dvec3 viewer = direction(0.9, 2.8);
    // Mixtures of two complementary checkerboards are exact.
    const auto board = [](float first, float second) {
        return checkerboard_texture(glm::vec3(first), glm::vec3(second), 1);
    };
    const MaterialPtr boards = with_roughness(brushed, board(0.05F, 0.3F), board(0.3F, 0.05F));
    CHECK(boards->anisotropic());
    CHECK(boards->variation()->layers.size() == 4);
    for (const auto& [uv, u, v] :
         {std::tuple{glm::vec2(0.25F, 0.25F), 0.05F, 0.3F}, std::tuple{glm::vec2(0.25F, 0.75F), 0.3F, 0.05F}})
        CHECK(largest_difference(matrix_at(*boards, 0, uv, light, viewer),
                                 evaluate(*brushed(static_cast<double>(u), static_cast<double>(v)), 0, light,
                                          viewer)) < 1e-9);
    // A constant needs fewer layers, and a continuous texture needs few layers.
    const TexturePtr ramp = texture_of([](const TexturePoint& p) { return glm::vec4(0.1F + 0.3F * p.uv.x); },
                                       1, glm::vec2(0.1F, 0.4F));
    const MaterialPtr mixed = with_roughness(brushed, ramp, constant_texture(glm::vec4(0.2F), 1));
    CHECK(mixed->variation()->layers.size() <= 8);
    const MaterialPtr both = with_roughness(brushed, ramp, ramp);
    CHECK(both->variation()->layers.size() <= 64);
    for (const float x : {0.1F, 0.5F, 0.8F}) {
        const double alpha = 0.1 + 0.3 * static_cast<double>(x);
        const Mueller expected = evaluate(*brushed(alpha, alpha), 0, light, viewer);
        CHECK(largest_difference(matrix_at(*both, 0, {x, 0}, light, viewer), expected) <
              0.05 * expected(0, 0));
    }
}

TEST_CASE("between its alphas a roughness texture misses about one percent of a response") {
    const LightLayout layout(9, LightKind::linear);
    for (const double alpha : {0.05, 0.2, 0.5}) {
        const TexturePtr values = texture_of([](const TexturePoint& p) { return glm::vec4(p.uv.x); }, 1,
                                             glm::vec2(alpha, 1.19 * alpha));
        const MaterialPtr material = with_roughness(gloss, values);
        REQUIRE(material->variation()->layers.size() == 2);
        const double middle = 1.09 * alpha;
        std::vector<glm::vec3> weights(2);
        material->variation()->weights({.uv = glm::vec2(middle, 0)}, weights);
        CHECK(weights[0].x + weights[1].x == Approx(1).epsilon(1e-6));
        const ResponseTable exact(*gloss(middle), layout, 1);
        const ResponseTable low(*material->variation()->layers[0].material, layout, 1);
        const ResponseTable high(*material->variation()->layers[1].material, layout, 1);
        double off = 0;
        double all = 0;
        for (std::size_t i = 0; i < exact.data().size(); ++i) {
            const double mixed =
                static_cast<double>(weights[0].x * low.data()[i] + weights[1].x * high.data()[i]);
            off += (mixed - static_cast<double>(exact.data()[i])) *
                   (mixed - static_cast<double>(exact.data()[i]));
            all += static_cast<double>(exact.data()[i]) * static_cast<double>(exact.data()[i]);
        }
        CHECK(std::sqrt(off / all) < 0.015);
    }
}

TEST_CASE("what varies nowhere has no variation") {
    const MaterialPtr base = pplastic({});
    const TexturePtr half = constant_texture(glm::vec4(0.5F), 1);
    const TexturePtr flat = constant_texture(glm::vec4(0.5F, 0.5F, 1, 1), 3);
    const TexturePtr clear = constant_texture(glm::vec4(1), 1);
    CHECK(normal_mapped(base, flat) == base);
    CHECK(bump_mapped(base, half, 3) == base);
    CHECK(masked(base, clear) == base);
    CHECK(scaled(base, clear) == base);
    const glm::dvec3 light = glm::normalize(glm::dvec3(0.3, 0.2, 0.8));
    const glm::dvec3 viewer = glm::normalize(glm::dvec3(-0.5, 0.1, 0.6));
    const Mueller whole = evaluate(*base, 0, light, viewer);
    const struct {
        MaterialPtr material;
        Mueller expected;
    } rows[] = {{scaled(base, half), 0.5 * whole},
                {blend(base, scaled(base, half), half), 0.75 * whole},
                {scaled(base, constant_texture(glm::vec4(0), 1)), 0.0 * whole},
                {with_roughness(gloss, constant_texture(glm::vec4(0.25F), 1)),
                 evaluate(*gloss(0.25), 0, light, viewer)}};
    for (const auto& row : rows) {
        CHECK(row.material->variation() == nullptr);
        CHECK(largest_difference(evaluate(*row.material, 0, light, viewer), row.expected) <=
              1e-6 * whole(0, 0));
    }
}

TEST_CASE("the mean of a material that varies is that of its textures") {
    const MaterialPtr red = diffuse({0.8, 0.1, 0.1});
    const MaterialPtr material = scaled(red, ramp_texture());
    const glm::dvec3 up(0, 0, 1);
    CHECK(evaluate(*material, 0, up, up)(0, 0) == Approx(0.5 * evaluate(*red, 0, up, up)(0, 0)));
    CHECK(material->channels() == 3);
}

TEST_CASE("one-sided parts of a mixture are black on its back") {
    const MaterialPtr one = diffuse({0.8}),
                      metal = twosided(rough_conductor({.eta = {{0.2, -3.2}}, .alpha = 0.1, .alpha_v = 0.3}));
    const glm::dvec3 light = glm::normalize(glm::dvec3(0.3, 0.2, 1)), viewer(0.6, 0, 0.8);
    for (const TexturePtr& weight : {constant_texture(glm::vec4(0.25F), 1), ramp_texture()}) {
        const MaterialPtr mixture = blend(one, metal, weight);
        CHECK(mixture->twosided());
        // The tables' materials have the same sides.
        CHECK(mixture->anisotropic());
        CHECK(mixture->isotropic().twosided());
        const MaterialPtr behind = mixture->behind();
        REQUIRE(behind);
        CHECK(behind->twosided());
        CHECK(!behind->behind());
        const double share = static_cast<double>(weight->mean().x);
        const auto of = [&](const MaterialPtr& material) { return evaluate(*material, 0, light, viewer); };
        const auto check = [](const Mueller& actual, const Mueller& expected) {
            CHECK(largest_difference(numbers_in(actual), numbers_in(expected)) < 1e-6);
        };
        check(of(behind), share * of(metal));
        check(of(mixture), (1 - share) * of(one) + share * of(metal));
    }
    const TexturePtr half = constant_texture(glm::vec4(0.5F), 1);
    CHECK(!blend(one, one, half)->behind());
    CHECK(!blend(metal, metal, half)->behind());
    const MaterialPtr both = twosided(blend(one, metal, half));
    CHECK((both->twosided() && !both->behind()));
    const MaterialPtr opaque = masked(blend(one, metal, half), ramp_texture());
    CHECK(opacity_of(*opaque->behind()) == opacity_of(*opaque));
}

TEST_CASE("principled of which some terms alone are anisotropic is two-sided throughout") {
    const MaterialPtr plain = principled({.roughness = 0.5, .anisotropic = 0.8, .clearcoat = 1});
    const MaterialPtr both = twosided(plain);
    int brushed = 0;
    for (int t = 0; t < plain->terms(); ++t)
        if (plain->lobe_widths(t).x != plain->lobe_widths(t).y) ++brushed;
    CHECK(brushed > 0);
    CHECK(brushed < plain->terms());
    CHECK(both->isotropic().twosided());
    const auto behind = [](const glm::dvec3& d) { return glm::dvec3(d.x, d.y, -d.z); };
    const glm::dvec3 light = direction(0.6, 2), viewer = direction(0.9, 0.3);
    for (const Material* const material : {both.get(), &both->isotropic()}) {
        const double front = evaluate(*material, 0, light, viewer)(0, 0);
        CHECK(front > 0);
        CHECK(evaluate(*material, 0, behind(light), behind(viewer))(0, 0) == Approx(front));
    }
    CHECK(evaluate(plain->isotropic(), 0, behind(light), behind(viewer))(0, 0) == 0);
    const MaterialPtr mixture = blend(both, twosided(diffuse({0.5})), constant_texture(glm::vec4(0.5F), 1));
    CHECK(mixture->isotropic().twosided());
}

TEST_CASE("parts that do not go together are refused") {
    const MaterialPtr base = pplastic({});
    const TexturePtr u = ramp_texture();
    const TexturePtr normals =
        texture_of([](const TexturePoint&) { return glm::vec4(0.6F, 0.5F, 0.9F, 1); }, 3);
    const auto message = [](const std::function<void()>& call) {
        try {
            call();
        } catch (const Error& error) {
            CHECK(error.code() == ErrorCode::invalid_argument);
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(message([&] { static_cast<void>(scaled(nullptr, u)); }).find("material is null") !=
          std::string::npos);
    CHECK(message([&] { static_cast<void>(scaled(base, nullptr)); }).find("texture is null") !=
          std::string::npos);
    CHECK(message([&] { static_cast<void>(sum(normal_mapped(base, normals), base)); }).find("normal maps") !=
          std::string::npos);
    CHECK(message([&] { static_cast<void>(normal_mapped(base, u)); }).find("1 channel") != std::string::npos);
    CHECK(message([&] {
              static_cast<void>(normal_mapped(normal_mapped(base, normals), normals));
          }).find("already") != std::string::npos);
    CHECK(message([&] {
              static_cast<void>(blend(diffuse({0.1, 0.2, 0.3, 0.4}), scaled(base, normals), u));
          }).find("channels") != std::string::npos);
    const MaterialPtr brushed = rough_conductor({.alpha = 0.1, .alpha_v = 0.3});
    CHECK(message([&] { static_cast<void>(rotated(brushed, u, 0)); }).find("1 channel") != std::string::npos);
    CHECK(message([&] {
              static_cast<void>(rotated(rotated(brushed, nullptr, 1), nullptr, 1));
          }).find("already") != std::string::npos);
    CHECK(message([&] {
              static_cast<void>(blend(rotated(brushed, nullptr, 1), brushed, u));
          }).find("different ways") != std::string::npos);
    CHECK(message([&] { static_cast<void>(masked(masked(base, u), u)); }).find("already") !=
          std::string::npos);
}

TEST_CASE("a mixture is rotated as its anisotropic parts are") {
    const MaterialPtr brushed = rough_conductor({.alpha = 0.1, .alpha_v = 0.3});
    const MaterialPtr turned = rotated(brushed, nullptr, 1);
    const MaterialPtr round = diffuse({0.5});
    CHECK(rotated(round, nullptr, 1) == round);
    for (const MaterialPtr& whole :
         {turned, sum(turned, round), sum(round, turned), sum(turned, turned), twosided(turned)}) {
        REQUIRE(whole->variation());
        CHECK(whole->variation()->rotation == TangentRotation{.directions = nullptr, .angle = 1});
    }
}
