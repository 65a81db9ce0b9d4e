// SPDX-License-Identifier: MIT
#include "material/plastic.hpp"

#include "directions.hpp"
#include "function_texture.hpp"
#include "material/boundary_transmittance.hpp"
#include "material/conductor.hpp"
#include "material/microfacet.hpp"
#include "material/spatial_variation.hpp"
#include "polarization/fresnel.hpp"
#include "test.hpp"

using namespace nicol;
using test::texture_of;

namespace {

constexpr auto beckmann = Distribution::beckmann;
constexpr auto ggx = Distribution::ggx;

double differs(double found, double expected) {
    return std::abs(found - expected) / std::max(expected, 1e-9);
}

double reflectance(double cosine, double eta) {
    return fresnel_reflection(cosine, eta)(0, 0);
}

/// Returns the share of light that facets transmit, by integrating over facet normals. Refracted light counts
/// only if it leaves by visible facets.
double transmittance(double eta, Distribution distribution, double alpha, double zenith) {
    const glm::dvec3 from = direction(zenith, 0);
    const int n = 1200;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double theta = (i + 0.5) * pi / 2 / n;
        for (int k = 0; k < 200; ++k) {
            const glm::dvec3 facet = direction(theta, 2 * pi * (k + 0.5) / 200);
            const double cosine = glm::dot(facet, from);
            if (cosine <= 0) continue;
            const glm::dvec3 refracted = glm::refract(-from, facet, 1 / eta);
            sum += (1 - reflectance(cosine, eta)) * cosine * facet_density(distribution, alpha, facet.z) *
                   facet_visibility(distribution, alpha, from.z) *
                   facet_visibility(distribution, alpha, -refracted.z) * std::sin(theta);
        }
    }
    return sum / from.z * pi / 2 / n * 2 * pi / 200;
}

}  // namespace

TEST_CASE("plastic is as Mitsuba evaluates it") {
    // Values of Mitsuba 3.9.1, scalar_rgb: eval() divided by the cosine, with diffuse_reflectance (0.2, 0.5,
    // 0.9), specular_reflectance (1, 0.5, 0), int_ior as given and ext_ior 1. The angles are the zenith of
    // the viewer, that of the light, and the azimuth between them.
    struct Value {
        double viewer, light, azimuth;
        std::array<double, 3> rgb;
    };
    const struct {
        std::string name;
        double int_ior;
        double alpha;  // 0: smooth; eval() omits the mirror reflection
        Distribution distribution;
        bool nonlinear;
        std::vector<Value> values;
    } rows[] = {
        {"linear",
         1.5,
         0,
         beckmann,
         false,
         {{0, 0, 0, {0.0646743, 0.1616856, 0.2910341}},
          {0.9, 1.2, 0.7, {0.0556183, 0.1390457, 0.2502822}},
          {1.4, 1.4, 3, {0.0256750, 0.0641876, 0.1155377}}}},
        {"nonlinear",
         1.5,
         0,
         beckmann,
         true,
         {{0, 0, 0, {0.0296103, 0.0929167, 0.2535090}}, {1.5, 0.2, 1, {0.0101652, 0.0318983, 0.0870297}}}},
        {"dense",
         1.9,
         0,
         beckmann,
         true,
         {{0, 0, 0, {0.0169978, 0.0582448, 0.2072734}}, {1.4, 1.4, 3, {0.0067503, 0.0231307, 0.0823144}}}},
        {"rough",
         1.5,
         0.3,
         beckmann,
         false,
         {{0, 0, 0, {0.0908187, 0.1563112, 0.2495292}},
          {0.5, 0.3, 2, {0.0798524, 0.1503626, 0.2484819}},
          {1.4, 1.4, 3, {1.8364255, 0.9891667, 0.1596464}},
          {1.5, 0.2, 1, {0.0413522, 0.1033699, 0.1860611}}}},
        {"rough and nonlinear",
         1.5,
         0.3,
         beckmann,
         true,
         {{0, 0, 0, {0.0645214, 0.1063337, 0.2242449}}, {1.4, 1.4, 3, {1.8196008, 0.9571915, 0.1434697}}}},
        {"ggx",
         1.5,
         0.1,
         ggx,
         true,
         {{0, 0, 0, {0.3475943, 0.2491070, 0.2329328}},
          {0.9, 1.2, 0.7, {0.0254329, 0.0774517, 0.2002256}},
          {1.5, 0.2, 1, {0.0192297, 0.0556196, 0.1422926}}}},
        {"very rough",
         1.5,
         1,
         ggx,
         false,
         {{0, 0, 0, {0.0280550, 0.0637713, 0.1119236}},
          {0.9, 1.2, 0.7, {0.0188177, 0.0354530, 0.0585992}},
          {1.4, 1.4, 3, {0.0913065, 0.0570231, 0.0255821}},
          {1.5, 0.2, 1, {0.0162547, 0.0269206, 0.0422848}}}},
    };
    for (const auto& row : rows) {
        const MaterialPtr material = plastic({.diffuse_reflectance = {0.2, 0.5, 0.9},
                                              .specular_reflectance = {1, 0.5, 0},
                                              .int_ior = row.int_ior,
                                              .ext_ior = 1,
                                              .alpha = row.alpha,
                                              .distribution = row.distribution,
                                              .nonlinear = row.nonlinear});
        for (const Value& value : row.values) {
            for (int c = 0; c < 3; ++c) {
                CAPTURES(row.name, value.viewer, value.light, c);
                double found = 0;
                for (int t = 0; t < 2; ++t)
                    if (!material->smooth(t))
                        found += material->weight(t, c) *
                                 material->evaluate(t, direction(value.light, value.azimuth),
                                                    direction(value.viewer, 0))(0, 0);
                CHECK(differs(found, value.rgb[static_cast<std::size_t>(c)]) < 0.0015);
            }
        }
    }
}

TEST_CASE("plastic depolarizes") {
    std::mt19937 random(4);
    for (const double alpha : {0.0, 0.2}) {
        const MaterialPtr material = plastic({.alpha = alpha});
        for (int i = 0; i < 50; ++i) {
            const Mueller m = evaluate(*material, 0, random_direction_within(random, 1.5),
                                       random_direction_within(random, 1.5));
            Mueller expected;
            expected(0, 0) = m(0, 0);
            CHECK(largest_difference(m, expected) == 0);
            CHECK(m(0, 0) > 0);
        }
    }
}

TEST_CASE("only the boundary of smooth plastic is smooth") {
    const MaterialPtr smooth = plastic({});
    CHECK_FALSE(smooth->smooth(0));
    CHECK(smooth->smooth(1));
    CHECK(smooth->lobe_width(1) == kSmoothAlpha);
    CHECK_FALSE(plastic({.alpha = kSmoothAlpha})->smooth(1));
    CHECK(twosided(smooth)->smooth(1));
    CHECK(conductor({{0.2, -3}})->smooth(0));
    CHECK_FALSE(rough_conductor({})->smooth(0));
}

TEST_CASE("a boundary lets through what its facets refract") {
    for_all({0.9, 1.3, 1.8}, {0.0, 0.6, 1.2, 1.45}, [](double eta, double zenith) {
        CAPTURES(eta, zenith);
        const double cosine = std::cos(zenith);
        CHECK(std::abs(BoundaryTransmittance(eta).at(cosine) + reflectance(cosine, eta) - 1) < 1e-14);
        const auto error = [&](Distribution distribution, double alpha) {
            return BoundaryTransmittance(eta, distribution, alpha).at(cosine) -
                   transmittance(eta, distribution, alpha, zenith);
        };
        // Total reflection begins abruptly between table points.
        const double tolerance = eta < 1 ? 0.01 : 0.002;
        for (const double alpha : {0.15, 0.5, 1.0}) CHECK(std::abs(error(ggx, alpha)) < tolerance);
        // The visibility of Beckmann facets is known only by a fit.
        CHECK(std::abs(error(beckmann, 0.4)) < 0.005);
    });
}

TEST_CASE("a boundary returns the share of diffuse light that Fresnel's formulas say") {
    for (const double eta : {0.7, 1.2, 1.5, 1.9}) {
        CAPTURE(eta);
        double returned = 0;
        const int n = 20000;
        for (int i = 0; i < n; ++i) {
            const double cosine = (i + 0.5) / n;
            returned += 2 * cosine * reflectance(cosine, 1 / eta) / n;
        }
        CHECK(differs(BoundaryTransmittance(eta).returned(), returned) < 0.01);
        // The facets are nearly smooth, and the ends contribute too much to their sum.
        CHECK(differs(BoundaryTransmittance(eta, beckmann, 0.005).returned(), returned) < 0.03);
    }
}

TEST_CASE("textures of plastic are its parameters at every point") {
    const auto u = [](const TexturePoint& p) { return glm::vec4(p.uv.x, 0.5F * p.uv.x, p.uv.y, 1); };
    const TexturePtr color = texture_of(u, 3);
    const TexturePtr rough =
        texture_of([](const TexturePoint& p) { return glm::vec4(p.uv.x > 0.5F ? 0.4F : 0.1F); }, 1,
                   glm::vec2(0.1F, 0.4F));
    for_all({false, true}, {false, true}, [&](bool nonlinear, bool varies) {
        CAPTURES(nonlinear, varies);
        const MaterialPtr material = plastic({.diffuse_reflectance = color,
                                              .specular_reflectance = color,
                                              .alpha = {0.1, varies ? rough : nullptr},
                                              .nonlinear = nonlinear});
        CHECK(material->channels() == 3);
        const SpatialVariation& variation = *material->variation();
        std::vector<glm::vec3> weights(variation.layers.size());
        const glm::dvec3 light = direction(0.5, 2), viewer = direction(0.6, -1.2);
        for (const glm::vec2 uv : {glm::vec2(0.2, 0.9), glm::vec2(0.8, 0.3), glm::vec2(1, 0)}) {
            variation.weights({.uv = uv}, weights);
            const glm::vec4 at = u({.uv = uv});
            PlasticParameters there{.alpha = varies && uv.x > 0.5F ? 0.4 : 0.1, .nonlinear = nonlinear};
            for (glm::length_t c = 0; c < 3; ++c) {
                there.diffuse_reflectance = there.specular_reflectance = {static_cast<double>(at[c])};
                double found = 0;
                for (std::size_t l = 0; l < weights.size(); ++l)
                    found += static_cast<double>(weights[l][c]) *
                             evaluate(*variation.layers[l].material, 0, light, viewer)(0, 0);
                CHECK(differs(found, evaluate(*plastic(there), 0, light, viewer)(0, 0)) < 1e-5);
            }
        }
    });
}

TEST_CASE("plastic out of range is named") {
    const auto bad = ErrorCode::invalid_argument;
    check_error(bad, CALL(plastic({.diffuse_reflectance = {1.5}})), "diffuse_reflectance");
    check_error(bad, CALL(plastic({.specular_reflectance = {-1}})), "specular_reflectance");
    check_error(bad, CALL(plastic({.int_ior = 0})), "int_ior");
    check_error(bad, CALL(plastic({.ext_ior = -1})), "ext_ior");
    check_error(bad, CALL(plastic({.alpha = 0.0005})), "alpha");
    check_error(bad, CALL(plastic({.alpha = std::nan("")})), "alpha");
    check_error(bad, CALL(plastic({.diffuse_reflectance = {.1, .2}, .specular_reflectance = {.1, .2, .3}})),
                "channels");
}
