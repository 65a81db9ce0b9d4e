// SPDX-License-Identifier: MIT
#include "material/sampled_terms.hpp"

#include "directions.hpp"
#include "material/conductor.hpp"
#include "material/mixture.hpp"
#include "material/principled.hpp"
#include "material/response_table.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("anisotropic terms are sampled, and narrow ones under an image") {
    const auto metal = [](double alpha, double alpha_v) {
        return rough_conductor({.eta = {{1.5, -7}}, .alpha = alpha, .alpha_v = alpha_v});
    };
    const struct {
        std::string name;
        MaterialPtr material;
        bool anisotropic, narrow;  // whether it has sampled terms
    } rows[] = {
        {"diffuse", diffuse({0.5}), false, false},
        {"round", metal(0.3, 0), false, false},
        {"narrow", metal(0.05, 0), false, true},
        {"brushed", metal(0.2, 0.5), true, true},
        {"smooth", conductor({{1.5, -7}}), false, true},
        {"two-sided", twosided(metal(0.2, 0.5)), true, true},
        {"plastic", pplastic({.alpha = 0.02}), false, true},
        {"blend", blend(diffuse({0.5}), metal(0.2, 0.5), constant_texture(glm::vec4(0.3F), 1)), true, true}};
    for (const auto& row : rows) {
        CAPTURE(row.name);
        const auto any = [&](SampledTerms sampled) {
            return any_term(*row.material, [=](const Material& layer, int term) {
                return is_sampled(layer, term, sampled);
            });
        };
        CHECK(!any(SampledTerms::none));
        CHECK(any(SampledTerms::anisotropic) == row.anisotropic);
        CHECK(any(SampledTerms::anisotropic_narrow) == row.narrow);
        CHECK(any({SampledTerms::anisotropic_narrow, 0.31}) == (row.narrow || row.name == "round"));
    }
}

TEST_CASE("harmonics and samples together are the material") {
    const MaterialPtr plastic = pplastic({.diffuse_reflectance = {0.2, 0.5, 0.9}, .alpha = 0.02});
    const MaterialPtr rest = in_harmonics(plastic, SampledTerms::anisotropic_narrow);
    CHECK(in_harmonics(plastic, SampledTerms::anisotropic) == plastic);
    CHECK(rest->channels() == 3);
    CHECK(rest->content_key() != plastic->content_key());
    for (const glm::dvec3& light : {direction(0.4, 0.3), direction(1.2, 2)}) {
        const glm::dvec3 viewer = direction(0.6, 1);
        for (int c = 0; c < 3; ++c) {
            Mueller sum = evaluate(*rest, c, light, viewer);
            for (int t = 0; t < plastic->terms(); ++t)
                if (is_sampled(*plastic, t, SampledTerms::anisotropic_narrow))
                    sum = sum + plastic->weight(t, c) * plastic->evaluate(t, light, viewer);
            CHECK(largest_difference(numbers_in(sum), numbers_in(evaluate(*plastic, c, light, viewer))) <
                  1e-12);
        }
    }
    // Lanes agree with the terms one by one.
    LaneVectors lights, viewers;
    for (std::size_t i = 0; i < kLanes; ++i) {
        put(lights, i, glm::vec3(direction(0.1 * static_cast<double>(i), 1)));
        put(viewers, i, glm::vec3(direction(0.5, 0.2 * static_cast<double>(i))));
    }
    std::vector<LaneMueller> lanes(static_cast<std::size_t>(rest->terms()));
    rest->evaluate_lanes(lights, viewers, 4, lanes);
    for (std::size_t i = 1; i < 14; ++i)
        CHECK(static_cast<double>(lanes[0].m[0][i]) ==
              doctest::Approx(rest->evaluate(0, direction(0.1 * static_cast<double>(i), 1),
                                             direction(0.5, 0.2 * static_cast<double>(i)))(0, 0))
                  .epsilon(1e-4));

    // A material without other terms is black in harmonics.
    const MaterialPtr brushed = rough_conductor({.eta = {{1.5, -7}}, .alpha = 0.2, .alpha_v = 0.4});
    const ResponseTable black(*in_harmonics(brushed, SampledTerms::anisotropic),
                              LightLayout(3, LightKind::full), 3);
    for (const float value : black.rows(10, 0)) CHECK(value == 0);
}
