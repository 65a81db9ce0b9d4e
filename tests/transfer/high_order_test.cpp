// SPDX-License-Identifier: MIT
#include "transfer/high_order.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "material/brute_force.hpp"
#include "material/high_order_gains.hpp"
#include "material/high_order_kernel.hpp"
#include "nicol/conductor.hpp"
#include "nicol/environment.hpp"
#include "nicol/error.hpp"
#include "nicol/material_projection.hpp"
#include "nicol/psh_matrix_file.hpp"
#include "transfer/high_order_light.hpp"
#include "transfer/high_order_scene.hpp"

using namespace nicol;

namespace {

constexpr int l_low = 4;

MaterialPtr plastic(double alpha) {
    return pplastic({.diffuse_reflectance = {0.6, 0.35, 0.1},
                     .int_ior = 1.5,
                     .ext_ior = 1,
                     .alpha = alpha,
                     .distribution = Distribution::ggx});
}

MaterialPtr gold(double alpha) {
    return rough_conductor({.eta = metal_index("Au"), .alpha = alpha, .distribution = Distribution::ggx});
}

// A blurring mirror that polarizes as a convolution can: with every band of the kernel.
MaterialPtr mirrored_convolution(int order) {
    ConvolutionKernel kernel(static_cast<std::size_t>(order) + 1);
    for (int l = 0; l <= order; ++l) {
        KernelBand& k = kernel[static_cast<std::size_t>(l)];
        const double unit = std::exp(-0.02 * l * l) * std::sqrt((2 * l + 1) / (4 * std::numbers::pi));
        k.k00 = unit;
        k.k33 = 0.6 * unit;
        if (l < 2) continue;
        k.p0 = k.from_p0 = 0.1 * unit;
        k.iso = 0.8 * unit;
        k.conj = 0.05 * unit;
    }
    return psh_matrix_material({compose(reflection_matrix(order), kernel_matrix(kernel))});
}

test::Picture convolved(const test::SphereView& sphere, const Material& material, const PshVector& light,
                        const test::Picture& low, int order) {
    const LobeMap map =
        convolved_map(light, mirrored_kernels(material, order, light.channels()), l_low, order);
    const HighOrderFactors mirror = HighOrderFactors::mirror();
    return sphere.with(low, HighOrder(mirror, {.centre = &map}, glm::dmat3(1.0)));
}

test::Picture split(const test::SphereView& sphere, const Material& material, const PshVector& light,
                    const test::Picture& low, int order, bool polarized) {
    const HighOrderFactors factors(material, l_low, order, light.channels());
    HighOrderLight filtered(light, l_low, order, polarized);
    return sphere.with(low, HighOrder(factors, filtered.maps(factors), glm::dmat3(1.0)));
}

}  // namespace

TEST_CASE("of a material that is a convolution about the mirror direction, convolution is all of it") {
    constexpr int order = 16;
    const MaterialPtr material = mirrored_convolution(order);
    const PshVector light = test::random_light(order, 1, 4, 3);
    const test::SphereView sphere(8, 12);
    const auto local = sphere.local(light, LightKind::full);
    const auto pictures = sphere.reflected(*material, local, {l_low, order});
    const auto low = test::relative_error(pictures[0], pictures[1]);
    const HighOrderFactors mirror = HighOrderFactors::mirror();
    const auto kernels = mirrored_kernels(*material, order, 1);
    const auto error = [&](double tolerance) {
        const LobeMap map = convolved_map(light, kernels, l_low, order, tolerance);
        return test::relative_error(
            sphere.with(pictures[0], HighOrder(mirror, {.centre = &map}, glm::dmat3(1.0))), pictures[1]);
    };
    // What is left is the interpolation in the map.
    const auto fine = error(2e-4);
    const auto usual = error(LobeMap::kTolerance);
    for (std::size_t p = 0; p < 4; ++p) {
        CAPTURE(p);
        CHECK(low[p] > 0.1);
        CHECK(fine[p] < 1e-4);
        CHECK(usual[p] < 5e-4);
    }
}

TEST_CASE("the split form comes close to the full transfer of polarized light") {
    constexpr int order = 20;
    const PshVector light = test::random_light(order, 3, 4, 11);
    const test::SphereView sphere(6, 10);
    const auto local = sphere.local(light, LightKind::full);
    for (const MaterialPtr& material : {plastic(0.3), gold(0.2)}) {
        const auto pictures = sphere.reflected(*material, local, {l_low, order});
        const auto low = test::relative_error(pictures[0], pictures[1]);
        const auto convolution =
            test::relative_error(convolved(sphere, *material, light, pictures[0], order), pictures[1]);
        const auto found =
            test::relative_error(split(sphere, *material, light, pictures[0], order, true), pictures[1]);
        for (std::size_t p = 0; p < 4; ++p) {
            CAPTURE(p);
            CHECK(found[p] < 0.3 * low[p]);
            CHECK(found[p] < 0.3 * convolution[p]);
        }
    }
}

TEST_CASE("under real light the split form halves what convolution misses, and keeps polarization") {
    const char* data = std::getenv("NICOL_TEST_DATA");
    const std::filesystem::path folder = std::filesystem::path(data == nullptr ? "" : data) / "mitsuba";
    if (data == nullptr || !std::filesystem::exists(folder / "env.exr")) {
        MESSAGE("skipped: NICOL_TEST_DATA has no mitsuba/env.exr");
        return;
    }
    constexpr int order = 64;
    struct Subject {
        std::string name;
        MaterialPtr material;
    };
    const std::vector<Subject> subjects{{"pplastic 0.1", plastic(0.1)},
                                        {"pplastic 0.2", plastic(0.2)},
                                        {"pplastic 0.3", plastic(0.3)},
                                        {"gold 0.2", gold(0.2)}};
    const test::SphereView sphere(12, 25);
    for (const std::string name : {"env.exr", "venice.exr"}) {
        const PshVector light = load_environment(folder / name)->project(order);
        const auto local = sphere.local(light, LightKind::unpolarized);
        for (const Subject& subject : subjects) {
            const Material& material = *subject.material;
            const auto pictures = sphere.reflected(material, local, {l_low, order});
            const auto report = [&](const std::string& what, const test::Picture& picture) {
                const auto error = test::relative_error(picture, pictures[1]);
                MESSAGE(name << ", " << subject.name << ", " << what << ": s0 " << error[0] << ", s1 "
                             << error[1] << ", s2 " << error[2]);
                return error;
            };
            report("0..4 alone", pictures[0]);
            const auto convolution =
                report("convolution to 9", convolved(sphere, material, light, pictures[0], 9));
            report("split to 9", split(sphere, material, light, pictures[0], 9, false));
            report("split to 32", split(sphere, material, light, pictures[0], 32, false));
            const auto error =
                report("split to 64", split(sphere, material, light, pictures[0], order, false));
            CHECK(error[0] < convolution[0] / 2);
            CHECK(error[1] < convolution[1] / 5);
            CHECK(error[2] < convolution[2] / 5);
            CHECK(error[0] < 0.01);
            CHECK(error[1] < 0.065);
            CHECK(error[2] < 0.06);
        }
    }
}

TEST_CASE("of a measured metal given as a matrix the split form keeps polarization too") {
    const char* data = std::getenv("NICOL_TEST_DATA");
    const std::filesystem::path folder = data == nullptr ? "" : data;
    const auto file = folder / "polarsh" / "SHMat_6_gold_ds1_L20_ISOBI2.npz";
    if (data == nullptr || !std::filesystem::exists(file)) {
        MESSAGE("skipped: NICOL_TEST_DATA has no polarsh/SHMat_6_gold_ds1_L20_ISOBI2.npz");
        return;
    }
    const MaterialPtr material = psh_matrix_material(read_psh_matrix(file));
    const int order = material->matrix(0)->order_in();
    const PshVector light = test::random_light(order, 3, 1, 1);
    const test::SphereView sphere(8, 10);
    const auto pictures =
        sphere.reflected(*material, sphere.local(light, LightKind::unpolarized), {l_low, order});
    const auto convolution =
        test::relative_error(convolved(sphere, *material, light, pictures[0], order), pictures[1]);
    const auto error =
        test::relative_error(split(sphere, *material, light, pictures[0], order, false), pictures[1]);
    for (std::size_t p = 0; p < 3; ++p) {
        CAPTURE(p);
        CHECK(error[p] < convolution[p] / 5);
        CHECK(error[p] < 0.1);
    }
}

TEST_CASE("turning the light turns the look-up") {
    const PshVector light = test::random_light(12, 1, 4, 8);
    const test::SphereView sphere(4, 9);
    const glm::dmat3 turn = frame_with_x(glm::normalize(glm::dvec3(1, -2, 0.5)), {0.3, 0.1, 1});
    const HighOrderFactors factors(*plastic(0.2), l_low, 12, 1 + 2);
    HighOrderLight still(light, l_low, 12, true);
    HighOrderLight turned_light(rotated(light, turn), l_low, 12, true);
    const auto black = sphere.black(3);
    const auto expected = sphere.with(black, HighOrder(factors, turned_light.maps(factors), glm::dmat3(1.0)));
    const auto found = sphere.with(black, HighOrder(factors, still.maps(factors), turn));
    for (const double e : test::relative_error(found, expected)) CHECK(e < 3e-3);
}

TEST_CASE("unpolarized light has the same look-up in maps of either kind") {
    const PshVector light = test::random_light(20, 5, 1, 2);
    const test::SphereView sphere(4, 5);
    const HighOrderFactors factors(*pplastic({.alpha = 0.2}), l_low, 20, 5);
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
    // One light for materials of several colours.
    const HighOrderFactors coloured(*gold(0.2), l_low, 20, 3);
    HighOrderLight grey(test::random_light(20, 1, 1, 2), l_low, 20, false);
    const auto c = sphere.with(sphere.black(3), HighOrder(coloured, grey.maps(coloured), glm::dmat3(1.0)));
    CHECK(c[0] != c[2]);
}

TEST_CASE("shadows dim the lobe and the base, vertices that are not visible are left alone") {
    const PshVector light = test::random_light(12, 1, 1, 4);
    const HighOrderFactors factors(*pplastic({.alpha = 0.2}), l_low, 12, 1);
    HighOrderLight filtered(light, l_low, 12, false);
    const HighOrder high(factors, filtered.maps(factors), glm::dmat3(1.0));
    Viewpoint view;
    view.orthographic = true;
    const glm::vec3 normal = glm::normalize(glm::vec3(0.4F, 0.2F, -1));
    const auto look = [&](const glm::vec2& fraction) {
        glm::vec4 out[1];
        high.look_up(view, {0, 0, 0}, normal, fraction, out);
        return out[0];
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
    high.run(view, positions, normals, visible, fractions, 0, 3, channels);
    CHECK(glm::distance(out[0], glm::vec4(5) + open) < 1e-6F);
    CHECK(out[1] == glm::vec4(5));
    CHECK(out[2] == glm::vec4(5));
}

TEST_CASE("seen head-on and from behind there is an answer") {
    const PshVector light = test::random_light(12, 1, 4, 4);
    const HighOrderFactors factors(*plastic(0.2), l_low, 12, 3);
    HighOrderLight filtered(light, l_low, 12, true);
    const HighOrder high(factors, filtered.maps(factors), glm::dmat3(1.0));
    Viewpoint view;
    view.orthographic = true;
    glm::vec4 head_on[3];
    high.look_up(view, {0, 0, 0}, {0, 0, -1}, {1, 1}, head_on);
    // The plane of incidence is undefined there; next to it s0 must be the same.
    glm::vec4 beside[3];
    for (const glm::vec3 normal : {glm::vec3(1e-3F, 0, -1), glm::vec3(0, -1e-3F, -1)}) {
        high.look_up(view, {0, 0, 0}, glm::normalize(normal), {1, 1}, beside);
        CHECK(head_on[0][0] == doctest::Approx(beside[0][0]).epsilon(0.05));
    }
    for (const glm::vec3 normal : {glm::vec3(0, 0, 1), glm::vec3(0, 0.6F, 0.8F)}) {
        high.look_up(view, {0, 0, 0}, normal, {1, 1}, beside);
        for (const glm::vec4& s : beside)
            for (int p = 0; p < 4; ++p) CHECK(std::isfinite(s[p]));
    }
}

TEST_CASE("maps and channels must fit") {
    const PshVector light = test::random_light(6, 2, 1, 4);
    const HighOrderFactors factors(*gold(0.3), l_low, 6, 3);
    HighOrderLight two(light, l_low, 6, false);
    CHECK_THROWS_AS(HighOrder(factors, two.maps(factors), glm::dmat3(1.0)), Error);
    HighOrderLight one(test::random_light(6, 1, 1, 4), l_low, 6, false);
    HighOrderMaps maps = one.maps(factors);
    CHECK_NOTHROW(HighOrder(factors, maps, glm::dmat3(1.0)));
    maps.around = nullptr;
    CHECK_THROWS_AS(HighOrder(factors, maps, glm::dmat3(1.0)), Error);
    maps = one.maps(factors);
    const LobeMap polarized(light, gaussian_gains(0.1, 5, 6), true);
    maps.normal = &polarized;
    CHECK_THROWS_AS(HighOrder(factors, maps, glm::dmat3(1.0)), Error);
    CHECK_THROWS_AS(HighOrder(factors, {}, glm::dmat3(1.0)), Error);
    CHECK_THROWS_AS(HighOrderLight(light, 6, 6, false), Error);
    CHECK_THROWS_AS((void)convolved_map(light, std::vector<ConvolutionKernel>(3, ConvolutionKernel(7)), 4, 6),
                    Error);
    CHECK_THROWS_AS((void)convolved_map(light, std::vector<ConvolutionKernel>(1, ConvolutionKernel(5)), 4, 6),
                    Error);
}
