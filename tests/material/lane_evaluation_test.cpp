// SPDX-License-Identifier: MIT
// Tests of Material::evaluate_lanes() against evaluate_terms().
#include "directions.hpp"
#include "material/clearcoat.hpp"
#include "material/conductor.hpp"
#include "material/material.hpp"
#include "material/mixture.hpp"
#include "material/plastic.hpp"
#include "material/principled.hpp"
#include "test.hpp"
#include "texture/texture.hpp"

using namespace nicol;

namespace {

using Pair = std::array<glm::dvec3, 2>;  // towards the light and the viewer

LaneVectors lanes(const std::vector<Pair>& pairs, std::size_t first, std::size_t which) {
    LaneVectors out;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::vec3 d(pairs[(first + i) % pairs.size()][which]);
        out.x[i] = d.x;
        out.y[i] = d.y;
        out.z[i] = d.z;
    }
    return out;
}

glm::dvec3 at(const LaneVectors& from, std::size_t i) {
    return {from.x[i], from.y[i], from.z[i]};
}

glm::dvec3 mirrored(const glm::dvec3& d) {
    return {-d.x, -d.y, d.z};
}

// Returns pairs of directions, including pairs near special ones.
std::vector<Pair> pairs(double alpha) {
    const glm::dvec3 up(0, 0, 1);
    std::mt19937 random(5);
    std::vector<Pair> out{{up, up}};
    const auto near = [&](const glm::dvec3& d, double distance) {
        return glm::normalize(d + distance * random_direction(random));
    };
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 a = random_direction_within(random, 1.57);
        const glm::dvec3 b = random_direction_within(random, 1.57);
        const glm::dvec3 grazing = direction(pi / 2 - 1e-3, i);
        const glm::dvec3 low = direction(pi / 2 - 1e-3, i + 3.1);
        out.insert(out.end(), {{a, b},
                               {a, a},
                               {a, mirrored(a)},
                               {a, near(mirrored(a), alpha)},
                               {a, up},
                               {up, a},
                               {up, near(up, 0.01 * alpha)},
                               {a, near(up, 1e-9)},
                               {near(up, 1e-12), near(up, 1e-9)},
                               {a, near(a, 1e-5)},
                               {a, near(a, 1e-3)},
                               {grazing, a},
                               {a, grazing},
                               {grazing, low},
                               {-a, b},
                               {a, -b},
                               {-a, -b}});
    }
    return out;
}

}  // namespace

TEST_CASE("sixteen pairs of directions at once, as one by one") {
    const auto plastic = [](double alpha, Distribution distribution, double ior) {
        return pplastic({.int_ior = ior, .ext_ior = 1, .alpha = alpha, .distribution = distribution});
    };
    const auto plain = [](const PlasticParameters& parameters) { return nicol::plastic(parameters); };
    const auto metal = [](double alpha, Distribution distribution) {
        return rough_conductor({.eta = metal_index("Au"), .alpha = alpha, .distribution = distribution});
    };
    const auto brushed = [](double alpha_u, double alpha_v, Distribution distribution) {
        return rough_conductor(
            {.eta = metal_index("Au"), .alpha = alpha_u, .alpha_v = alpha_v, .distribution = distribution});
    };
    const Distribution beckmann = Distribution::beckmann;
    const Distribution ggx = Distribution::ggx;
    const auto coated = [&](double thickness) {
        return rough_conductor({.eta = {{0.7, 0}},
                                .alpha = 0.2,
                                .film = film_table({.thickness = thickness, .eta = {1.4}}, 1, {0.7})});
    };
    const MaterialPtr coated_metal =
        rough_conductor({.eta = metal_index("Au"),
                         .alpha = 0.3,
                         .film = film_table({.thickness = 300, .eta = {1.4}}, 1, metal_index("Au"))});
    const MaterialPtr callback =
        callback_material({.reflect = [](int, const glm::dvec3& a, const glm::dvec3&) {
            return Mueller({1, 0.1 * a.z, 0, 0, 0.1 * a.z, 1, 0, 0, 0, 0, 0.9, 0, 0, 0, 0, 0.9});
        }});
    const auto disney = [](PrincipledParameters parameters) {
        parameters.sheen = parameters.flatness = parameters.metallic = parameters.spec_tint = 0.5;
        parameters.sheen_tint = parameters.clearcoat = 0.5;
        return principled(parameters);
    };
    const struct {
        std::string name;
        MaterialPtr material;
        double alpha;
    } rows[] = {
        {"diffuse", diffuse({0.5}), 1},
        {"plastic, beckmann", plastic(0.1, beckmann, 1.5), 0.1},
        {"plastic, ggx", plastic(0.1, ggx, 1.5), 0.1},
        {"plastic, rough", plastic(0.6, beckmann, 1.5), 0.6},
        {"plastic, smooth", plastic(0.05, beckmann, 1.5), 0.05},
        {"plastic, ggx, smooth", plastic(0.05, ggx, 1.5), 0.05},
        {"plastic, sharp", plastic(0.001, beckmann, 1.5), 0.001},
        {"plastic, ggx, sharp", plastic(0.001, ggx, 1.5), 0.001},
        {"plastic, brushed", pplastic({.ext_ior = 1, .alpha = 0.3, .alpha_v = 0.05, .distribution = ggx}),
         0.05},
        {"plastic, index near 1", plastic(0.2, ggx, 1.0003), 0.2},
        {"plastic, total reflection", plastic(0.2, ggx, 0.8), 0.2},
        {"metal, beckmann", metal(0.1, beckmann), 0.1},
        {"metal, ggx", metal(0.3, ggx), 0.3},
        {"brushed metal, beckmann", brushed(0.3, 0.1, beckmann), 0.1},
        {"brushed metal, ggx", brushed(0.05, 0.4, ggx), 0.05},
        {"metal, smooth", conductor(metal_index("Ag")), kSmoothAlpha},
        {"metal without absorption", rough_conductor({.eta = {{1.5, 0}}, .alpha = 0.2}), 0.2},
        {"coated metal", coated_metal, 0.3},
        {"below a clear coat", clearcoat(coated_metal, {.alpha = 0.4}), 0.3},
        {"brushed, below a clear coat", clearcoat(brushed(0.05, 0.4, ggx), {.alpha = 0.4}), 0.05},
        {"coated, total reflection", coated(300), 0.2},
        {"depolarizing plastic", plain({.alpha = 0.1}), 0.1},
        {"depolarizing plastic, ggx", plain({.alpha = 0.5, .distribution = ggx}), 0.5},
        {"depolarizing plastic, smooth", plain({}), kSmoothAlpha},
        {"depolarizing plastic, total reflection", plain({.int_ior = 0.8}), kSmoothAlpha},
        {"principled", disney({}), 0.25},
        {"principled, glossy", disney({.roughness = 0.2, .clearcoat_gloss = 1}), 0.04},
        {"principled, brushed", disney({.roughness = 0.4, .anisotropic = 0.9}), 0.05},
        {"principled, index below 1", disney({.eta = 0.8}), 0.25},
        {"principled sheen", principled({.base_color = {0}, .eta = 1, .sheen = 1}), 1},
        {"principled edge", principled({.base_color = {0}, .metallic = 1}), 0.25},
        {"two-sided", twosided(plastic(0.1, ggx, 1.5)), 0.1},
        {"sum", sum(diffuse({0.2}), metal(0.1, ggx)), 0.1},
        {"function", callback, 1},
    };
    for (const auto& row : rows) {
        const std::vector<Pair> directions = pairs(row.alpha);
        const Material& material = *row.material;
        const auto terms = static_cast<std::size_t>(material.terms());
        std::vector<LaneMueller> all(terms);
        std::vector<LaneMueller> first(terms);
        std::vector<Mueller> expected(terms);
        double worst = 0;
        Pair where{};
        bool nothing = true;
        bool same_column = true;
        for (std::size_t begin = 0; begin < directions.size(); begin += kLanes) {
            const LaneVectors light = lanes(directions, begin, 0);
            const LaneVectors viewer = lanes(directions, begin, 1);
            material.evaluate_lanes(light, viewer, 4, all);
            material.evaluate_lanes(light, viewer, 1, first);
            for (std::size_t i = 0; i < kLanes; ++i) {
                material.evaluate_terms(at(light, i), at(viewer, i), expected);
                for (std::size_t t = 0; t < terms; ++t) {
                    const double scale = largest(expected[t]);
                    for (std::size_t e = 0; e < 16; ++e) {
                        const double error =
                            std::abs(static_cast<double>(all[t].m[e][i]) - expected[t](e / 4, e % 4));
                        // Values vanish below the horizon and if an exponential underflows.
                        if (scale < 1e-20) nothing = nothing && error < 1e-20;
                        if (!(error <= worst * scale) && scale >= 1e-20) {
                            worst = error / scale;
                            where = {at(light, i), at(viewer, i)};
                        }
                        if (e % 4 == 0) same_column = same_column && all[t].m[e][i] == first[t].m[e][i];
                    }
                }
            }
        }
        CAPTURES(row.name, where[0].x, where[0].y, where[0].z, where[1].x, where[1].y, where[1].z);
        CHECK(worst <= 2e-5);
        CHECK(nothing);
        CHECK(same_column);
    }
}
