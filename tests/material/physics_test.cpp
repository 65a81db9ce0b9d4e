// SPDX-License-Identifier: MIT
// Tests of physical laws that every material must obey.
#include <stdexcept>

#include "directions.hpp"
#include "material/clearcoat.hpp"
#include "material/coated_plastic.hpp"
#include "material/conductor.hpp"
#include "material/material.hpp"
#include "material/measured.hpp"
#include "material/plastic.hpp"
#include "material/principled.hpp"
#include "material/response_table.hpp"
#include "pbsdf_file.hpp"
#include "polarization/fresnel.hpp"
#include "temporary_folder.hpp"
#include "test.hpp"

using namespace nicol;
using doctest::Approx;

namespace {

// Returns a perfect retarder by `retardance` that scatters uniformly, with axes along and across the plane of
// incidence. The result is physically realizable, polarizing and reciprocal.
Mueller retarder(double retardance) {
    const double c = std::cos(retardance) / pi;
    const double s = std::sin(retardance) / pi;
    return Mueller({1 / pi, 0, 0, 0, 0, 1 / pi, 0, 0, 0, 0, c, -s, 0, 0, s, c});
}

struct Named {
    std::string name;
    MaterialPtr material;
};

std::vector<Named> materials(const TemporaryFolder& folder) {
    const MaterialPtr gold = rough_conductor({.eta = metal_index("Au"), .alpha = 0.3});
    const auto path = folder / "gold.pbsdf";
    const auto angles = test::even_angles(31, 0, pi / 2);
    write_bytes(path, test::make_pbsdf(test::even_angles(25, -pi, pi), angles, angles, {450, 550, 650},
                                       [](std::size_t w, const glm::dvec3& i, const glm::dvec3& o) {
                                           // Measurements lack the glare of grazing directions.
                                           Mueller m = fresnel_reflection(
                                               std::sqrt((1 + glm::dot(i, o)) / 2),
                                               metal_index("Au", {450 + 100.0 * static_cast<double>(w)})[0]);
                                           m *= 1 / pi;
                                           return m;
                                       })
                          .bytes());
    return {
        {"diffuse", diffuse({0.9})},
        {"pplastic", pplastic({.diffuse_reflectance = {0.9}, .alpha = 0.2})},
        {"glossy pplastic", pplastic({.diffuse_reflectance = {1}, .alpha = 0.05})},
        {"dull pplastic", pplastic({.diffuse_reflectance = {1}, .alpha = 1})},
        {"pplastic ggx",
         pplastic({.diffuse_reflectance = {1}, .alpha = 0.5, .distribution = Distribution::ggx})},
        {"dense to thin", pplastic({.int_ior = 1, .ext_ior = 1.5, .alpha = 0.3})},
        {"smooth plastic", plastic({.diffuse_reflectance = {1}, .nonlinear = true})},
        {"rough plastic", plastic({.diffuse_reflectance = {1}, .alpha = 0.3})},
        {"dull plastic", plastic({.diffuse_reflectance = {1},
                                  .int_ior = 1.9,
                                  .alpha = 1,
                                  .distribution = Distribution::ggx,
                                  .nonlinear = true})},
        {"glass", rough_conductor({.eta = {{1.5, 0}}, .alpha = 0.2})},
        {"gold", gold},
        {"silver",
         rough_conductor({.eta = metal_index("Ag"), .alpha = 0.8, .distribution = Distribution::ggx})},
        {"gold below a clear coat",
         clearcoat(rough_conductor({.eta = metal_index("Au"), .alpha = 0.3}), {.factor = 0.8, .alpha = 0.1})},
        {"brushed gold", rough_conductor({.eta = metal_index("Au"), .alpha = 0.1, .alpha_v = 0.4})},
        {"smooth aluminium", conductor(metal_index("Al"))},
        {"principled", principled({.base_color = {0.8},
                                   .metallic = 0.3,
                                   .spec_tint = 0.4,
                                   .sheen = 0.2,
                                   .flatness = 0.5,
                                   .clearcoat = 0.3,
                                   .clearcoat_gloss = 0.5})},
        {"principled, brushed", principled({.roughness = 0.4, .anisotropic = 0.8, .metallic = 0.7})},
        {"principled, perfect metal", principled({.base_color = {1}, .roughness = 0.6, .metallic = 1})},
        {"principled, index below 1", principled({.metallic = 0.5, .eta = 0.8})},
        {"coated metal", rough_conductor({.eta = metal_index("Cr"),
                                          .alpha = 0.3,
                                          .film = film_table({.thickness = 250, .eta = {{2.2, -0.05}}}, 1,
                                                             metal_index("Cr"))})},
        {"coated plastic", coated_pplastic({.diffuse_reflectance = {1}, .alpha = 0.2},
                                           {.thickness = 300, .eta = {2.1}, .wavelengths = {}})},
        {"twosided", twosided(gold)},
        {"measured", load_measured(path)},
        {"retarder", callback_material({.reflect = [](int, const glm::dvec3&,
                                                      const glm::dvec3&) { return retarder(1.1); }})},
    };
}

}  // namespace

TEST_CASE("physical light stays physical: s0 >= |(s1, s2, s3)| whatever arrives") {
    const TemporaryFolder folder;
    std::mt19937 random(11);
    for (const auto& [name, material] : materials(folder)) {
        CAPTURE(name);
        for (int i = 0; i < 3000; ++i) {
            glm::dvec3 light = random_direction(random), viewer = random_direction(random);
            light.z = std::abs(light.z);
            viewer.z = std::abs(viewer.z);
            const glm::dvec3 p = random_direction(random);
            const Stokes in(1, p.x, p.y, p.z);
            for (int c = 0; c < material->channels(); ++c) {
                const Mueller m = evaluate(*material, c, light, viewer);
                const Stokes out = m * in;
                const double polarized = std::sqrt(out[1] * out[1] + out[2] * out[2] + out[3] * out[3]);
                // The measured table is discretized, and its colours are mixtures with negative weights.
                const double slack = name == "measured" ? 0.02 : 1e-9;
                CHECK(polarized <= out[0] + slack * m(0, 0) + 1e-100);
                CHECK(m(0, 0) >= 0);
            }
        }
    }
}

TEST_CASE("no more energy leaves than arrives, for unpolarized and for polarized light") {
    const TemporaryFolder folder;
    for (const auto& [name, material] : materials(folder)) {
        CAPTURE(name);
        // The first row of a table over constant light is the albedo for a viewer at that angle. By
        // reciprocity it equals the albedo for light from that angle. Linear light adds at most |row|.
        const LightLayout layout(0, LightKind::unpolarized);
        const ResponseTable table(*material, layout, material->channels());
        for (int angle = 0; angle < 500; angle += 19) {
            for (int c = 0; c < table.channels(); ++c) {
                const double albedo = static_cast<double>(table.rows(angle, c)[0]) * std::sqrt(4 * pi);
                CHECK(albedo > 0);
                CHECK(albedo < 1.01);
            }
        }
        std::mt19937 random(5);
        std::uniform_real_distribution<double> uniform;
        const int n = 150;
        if (name.starts_with("smooth")) continue;  // the lobe falls between these directions
        for (const double zenith : {0.3, 1.1}) {
            const glm::dvec3 light = direction(zenith, 0);
            for (const double azimuth : {0.0, 0.9, 2.2}) {
                const Stokes in(1, std::cos(azimuth), std::sin(azimuth), 0);
                double out = 0;
                for (int i = 0; i < n; ++i) {
                    for (int k = 0; k < 2 * n; ++k) {
                        const double u = (i + uniform(random)) / n;
                        const glm::dvec3 viewer = direction(std::asin(std::sqrt(u)), pi * (k + 0.5) / n);
                        out += (evaluate(*material, 0, light, viewer) * in)[0];
                    }
                }
                CHECK(out * pi / (2 * n * n) < 1.01);
            }
        }
    }
}

TEST_CASE("mirror symmetry and isotropy hold for what every material is in harmonics") {
    const TemporaryFolder folder;
    for (const auto& [name, made] : materials(folder)) {
        CAPTURE(name);
        const Material& material = made->isotropic();
        for (const double azimuth : {0.3, 1.7, 2.9}) {
            const Mueller left = evaluate(material, 0, direction(0.7, azimuth), direction(1.1, 0));
            const Mueller right = evaluate(material, 0, direction(0.7, -azimuth), direction(1.1, 0));
            const Mueller rotated = evaluate(material, 0, direction(0.7, azimuth + 1.3), direction(1.1, 1.3));
            for (std::size_t e = 0; e < 16; ++e) {
                const double sign = (e / 4 < 2) == (e % 4 < 2) ? 1 : -1;
                CHECK(std::abs(left(e / 4, e % 4) - sign * right(e / 4, e % 4)) <= 1e-9 * left(0, 0));
                CHECK(std::abs(left(e / 4, e % 4) - rotated(e / 4, e % 4)) <= 1e-9 * left(0, 0));
            }
        }
    }
}

TEST_CASE("extreme directions stay finite, and below the horizon there is nothing") {
    const TemporaryFolder folder;
    for (const Named& named : materials(folder)) {
        CAPTURE(named.name);
        const Material& material = *named.material;
        if (!material.twosided())
            for (const auto& [light, viewer] : {std::pair(2.0, 1.0), {1.0, 2.0}, {2.0, 2.0}})
                CHECK(evaluate(material, 0, direction(light, 0), direction(viewer, 0))(0, 0) == 0);
        for_all({0.0, 1e-300, 1e-160, 1e-9, 1.0, pi / 2 - 1e-6},
                {0.0, 1e-300, 1e-9, 1e-3, 1.0, pi / 2 - 1e-6}, {0.0, 1e-12, 1.0, pi},
                [&](double in, double out, double azimuth) {
                    const Mueller m = evaluate(material, 0, direction(in, azimuth), direction(out, 0));
                    CHECK(std::isfinite(largest(m)));
                });
    }
}

TEST_CASE("reciprocity: exchanging light and viewer transposes, with s2 mirrored") {
    const TemporaryFolder folder;
    const glm::dvec3 a = direction(0.7, 0.4), b = direction(1.2, 2.9);
    for (const auto& [name, material] : materials(folder)) {
        if (name == "measured") continue;  // the table is discretized
        CAPTURE(name);
        // Reversing a ray keeps x = theta-hat up to sign and reverses y: (s0, s1, -s2, s3).
        const Mueller forth = evaluate(*material, 0, a, b), back = evaluate(*material, 0, b, a);
        for (std::size_t e = 0; e < 16; ++e)
            CHECK(forth(e / 4, e % 4) ==
                  Approx(((e / 4 == 2) == (e % 4 == 2) ? 1 : -1) * back(e % 4, e / 4)));
    }
}

TEST_CASE("towards the light itself a facet reflects as at normal incidence, in frames that agree") {
    const MaterialPtr metal = rough_conductor({.eta = {{0.2, -3.2}}, .alpha = 0.5});
    for (const glm::dvec3& d : {direction(0, 0), direction(0.6, 1), direction(1.2, 4)}) {
        const Mueller exact = metal->evaluate(0, d, d);
        const glm::dvec3 beside = glm::normalize(d + glm::dvec3(1e-7, 2e-7, 0));
        const Mueller near = metal->evaluate(0, glm::normalize(d + glm::dvec3(1e-9, 3e-9, 0)), beside);
        if (d.z < 0.999) {
            CHECK(largest_difference(exact, near) < 1e-5 * exact(0, 0));
        }
        // Both x axes point along theta-hat, so s2 and s3 change sign and s1 does not.
        CHECK(exact(1, 1) == Approx(exact(0, 0)));
        CHECK(exact(2, 2) == Approx(-exact(0, 0)));
        CHECK(exact(3, 3) == Approx(-exact(0, 0)));
        CHECK(std::abs(exact(1, 2)) < 1e-9 * exact(0, 0));
    }
}

TEST_CASE("twosided reflects alike on both sides, and never through the surface") {
    const MaterialPtr front = pplastic({.alpha = 0.3});
    const MaterialPtr both = twosided(front);
    CHECK(both->twosided());
    CHECK_FALSE(front->twosided());
    const glm::dvec3 light = direction(0.6, 2);
    const glm::dvec3 viewer = direction(0.9, 0.3);
    const auto behind = [](const glm::dvec3& d) { return glm::dvec3(d.x, d.y, -d.z); };
    const Mueller expected = evaluate(*front, 0, light, viewer);
    const Mueller ahead = evaluate(*both, 0, light, viewer);
    const Mueller back = evaluate(*both, 0, behind(light), behind(viewer));
    // The mirror image in the surface reverses azimuths, so odd elements change sign.
    for (std::size_t e = 0; e < 16; ++e) {
        const double sign = (e / 4 < 2) == (e % 4 < 2) ? 1 : -1;
        CHECK(ahead(e / 4, e % 4) == expected(e / 4, e % 4));
        CHECK(back(e / 4, e % 4) == Approx(sign * expected(e / 4, e % 4)));
    }
    CHECK(evaluate(*both, 0, behind(light), viewer)(0, 0) == 0);
    CHECK(evaluate(*both, 0, light, behind(viewer))(0, 0) == 0);
    CHECK(evaluate(*front, 0, behind(light), behind(viewer))(0, 0) == 0);
    std::array<Mueller, 2> terms;
    both->evaluate_terms(behind(light), behind(viewer), terms);
    CHECK(terms[1](0, 0) == both->evaluate(1, behind(light), behind(viewer))(0, 0));
    CHECK_THROWS_AS(twosided(nullptr), Error);
}

TEST_CASE("a callback in s-frames is the material it computes") {
    const MaterialPtr metal = rough_conductor({.eta = {{0.2, -3.2}}, .alpha = 0.4});
    const auto reflect = [&](int channel, const glm::dvec3& light, const glm::dvec3& viewer) {
        const glm::dvec3 s = glm::cross(light, viewer);
        const double in = angle_between(theta_phi_frame(-light), frame_with_x(-light, s));
        const double out = angle_between(theta_phi_frame(viewer), frame_with_x(viewer, s));
        return (channel + 1.0) * in_rotated_frames(metal->evaluate(0, light, viewer), in, out);
    };
    const MaterialPtr made = callback_material({.reflect = reflect, .channels = 2, .lobe_width = 0.4});
    CHECK(made->channels() == 2);
    CHECK(made->content_key().empty());
    for (const double azimuth : {0.4, 2.0, 3.0, 5.5}) {
        const glm::dvec3 light = direction(0.5, azimuth);
        const glm::dvec3 viewer = direction(1.0, 0.2);
        const Mueller expected = metal->evaluate(0, light, viewer);
        const Mueller found = evaluate(*made, 1, light, viewer);
        for (std::size_t e = 0; e < 16; ++e)
            CHECK(found(e / 4, e % 4) == Approx(2 * expected(e / 4, e % 4)).epsilon(1e-9));
    }
    CHECK(evaluate(*made, 0, direction(2, 0), direction(1, 0))(0, 0) == 0);
    const LightLayout layout(3, LightKind::full);
    const ResponseTable expected(*metal, layout, 2);
    const ResponseTable found(*made, layout, 2);
    for (std::size_t j = 0; j < 4 * layout.row_size(); ++j)
        CHECK(std::abs(found.rows(500, 1)[j] - 2 * expected.rows(500, 0)[j]) < 1e-6F);
}

TEST_CASE("callbacks that are no isotropic, mirror symmetric, finite material are refused") {
    const auto message = [](CallbackParameters p) { return error_of(CALL(callback_material(std::move(p)))); };
    const auto even = [](int, const glm::dvec3&, const glm::dvec3&) { return retarder(0.3); };
    CHECK(message({}).find("null") != std::string::npos);
    CHECK(message({.reflect = even, .channels = 0}).find("channels") == 0);
    CHECK(message({.reflect = even, .channels = 17}).find("channels") == 0);
    CHECK(message({.reflect = even, .lobe_width = 0}).find("lobe_width") == 0);
    CHECK(message({.reflect = [](int, const glm::dvec3& i, const glm::dvec3&) {
              return (1 + i.x) * retarder(0);
          }}).find("isotropic") != std::string::npos);
    CHECK(message({.reflect = [](int, const glm::dvec3&, const glm::dvec3&) {
              return frame_rotation(0.3);
          }}).find("mirror") != std::string::npos);
    CHECK(message({.reflect = [](int, const glm::dvec3&, const glm::dvec3&) {
              return std::nan("") * retarder(0);
          }}).find("finite") != std::string::npos);
    // This fault occurs where the constructor does not check, and is found during evaluation.
    const MaterialPtr late = callback_material({.reflect = [](int, const glm::dvec3& i, const glm::dvec3&) {
        return (i.z > 0.99 ? HUGE_VAL : 1.0) * retarder(0);
    }});
    CHECK_THROWS_AS(ResponseTable(*late, LightLayout(1, LightKind::full), 1), Error);
    const MaterialPtr throwing =
        callback_material({.reflect = [](int, const glm::dvec3& i, const glm::dvec3&) {
            if (i.z > 0.99) throw std::runtime_error("the host's own");
            return retarder(0);
        }});
    CHECK_THROWS_WITH_AS(ResponseTable(*throwing, LightLayout(1, LightKind::full), 1), "the host's own",
                         std::runtime_error);
}
