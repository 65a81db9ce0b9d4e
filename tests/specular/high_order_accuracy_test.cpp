// SPDX-License-Identifier: MIT
// Tests of high orders against the full transfer.
#include "light/environment.hpp"
#include "material/brute_force.hpp"
#include "material/material_projection.hpp"
#include "material/psh_matrix_file.hpp"
#include "specular/convolution_kernel.hpp"
#include "specular/high_order_light.hpp"
#include "specular/high_order_scene.hpp"
#include "specular/split_fit.hpp"
#include "test.hpp"

using namespace nicol;
using test::gold;
using test::plastic;

namespace {

constexpr int l_low = 4;

// Returns a blurring mirror that polarizes as a convolution can, with every band of the kernel.
MaterialPtr mirrored_convolution(int order) {
    ConvolutionKernel kernel(static_cast<std::size_t>(order) + 1);
    for (int l = 0; l <= order; ++l) {
        KernelBand& k = kernel[static_cast<std::size_t>(l)];
        const double unit = std::exp(-0.02 * l * l) * std::sqrt((2 * l + 1) / (4 * pi));
        k.k00 = unit;
        k.k33 = 0.6 * unit;
        if (l < 2) continue;
        k.p0 = k.from_p0 = 0.1 * unit;
        k.iso = 0.8 * unit;
        k.conj = 0.05 * unit;
    }
    return psh_matrix_material({compose(reflection_matrix(order), kernel_matrix(kernel))});
}

test::Image convolved(const test::SphereView& sphere, const Material& material, const PshVector& light,
                      const test::Image& low, int order) {
    const LobeMap map =
        convolved_map(light, mirrored_kernels(material, order, light.channels()), l_low, order);
    const HighOrderFactors mirror = HighOrderFactors::mirror();
    return sphere.with(low, HighOrder(mirror, {.central = &map}, glm::dmat3(1.0)));
}

test::Image split(const test::SphereView& sphere, const Material& material, const PshVector& light,
                  const test::Image& low, int order, bool polarized) {
    const HighOrderFactors factors(material, SplitBasis(l_low, order), light.channels());
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
    const auto images = sphere.reflected(*material, local, {l_low, order});
    const auto low = test::relative_error(images[0], images[1]);
    const HighOrderFactors mirror = HighOrderFactors::mirror();
    const auto kernels = mirrored_kernels(*material, order, 1);
    const auto error = [&](double tolerance) {
        const LobeMap map = convolved_map(light, kernels, l_low, order, tolerance);
        return test::relative_error(
            sphere.with(images[0], HighOrder(mirror, {.central = &map}, glm::dmat3(1.0))), images[1]);
    };
    // Only the interpolation in the map remains.
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
        const auto images = sphere.reflected(*material, local, {l_low, order});
        const auto low = test::relative_error(images[0], images[1]);
        const auto convolution =
            test::relative_error(convolved(sphere, *material, light, images[0], order), images[1]);
        const auto found =
            test::relative_error(split(sphere, *material, light, images[0], order, true), images[1]);
        for (std::size_t p = 0; p < 4; ++p) {
            CAPTURE(p);
            CHECK(found[p] < 0.3 * low[p]);
            CHECK(found[p] < 0.3 * convolution[p]);
        }
    }
}

TEST_CASE("under real light the split form halves what convolution misses, and keeps polarization") {
    const std::filesystem::path folder = test_data("mitsuba/env.exr").parent_path();
    if (folder.empty()) return;
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
            const auto images = sphere.reflected(material, local, {l_low, order});
            const auto report = [&](const std::string& what, const test::Image& image) {
                const auto error = test::relative_error(image, images[1]);
                MESSAGE(name << ", " << subject.name << ", " << what << ": s0 " << error[0] << ", s1 "
                             << error[1] << ", s2 " << error[2]);
                return error;
            };
            const auto convolution =
                report("convolution to 9", convolved(sphere, material, light, images[0], 9));
            const auto error = report("split to 64", split(sphere, material, light, images[0], order, false));
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
    const auto file = test_data("polarsh/SHMat_6_gold_ds1_L20_ISOBI2.npz");
    if (file.empty()) return;
    const MaterialPtr material = psh_matrix_material(read_psh_matrix(file), {1.0}, true);
    const int order = material->matrix(0)->order_in();
    const PshVector light = test::random_light(order, 3, 1, 1);
    const test::SphereView sphere(8, 10);
    const auto images =
        sphere.reflected(*material, sphere.local(light, LightKind::unpolarized), {l_low, order});
    const auto convolution =
        test::relative_error(convolved(sphere, *material, light, images[0], order), images[1]);
    const auto error =
        test::relative_error(split(sphere, *material, light, images[0], order, false), images[1]);
    for (std::size_t p = 0; p < 3; ++p) {
        CAPTURE(p);
        CHECK(error[p] < convolution[p] / 5);
        CHECK(error[p] < 0.1);
    }
}

TEST_CASE("the split form keeps what breaks mirror symmetry in measured gold") {
    const auto file = test_data("polarsh/SHMat_6_gold_ds1_L20_ISOBI2.npz");
    const auto image = test_data("mitsuba/env.exr");
    if (file.empty() || image.empty()) return;
    const MaterialPtr whole = psh_matrix_material(read_psh_matrix(file));
    const MaterialPtr half = psh_matrix_material(read_psh_matrix(file), {1.0}, true);
    const int order = whole->matrix(0)->order_in();
    const test::SphereView sphere(12, 25);
    const PshVector light = load_environment(image)->project(order);
    const auto local = sphere.local(light, LightKind::unpolarized);
    const auto images = sphere.reflected(*whole, local, {l_low, order});
    const auto error = [&](const Material& material) {
        // Errors are relative to the RMS of s0, because gold polarizes little.
        const test::Image found = split(sphere, material, light, images[0], order, false);
        glm::dvec4 sum(0);
        double s0 = 0;
        for (std::size_t c = 0; c < found.size(); ++c)
            for (std::size_t v = 0; v < found[c].size(); ++v) {
                const glm::dvec4 d = glm::dvec4(found[c][v]) - glm::dvec4(images[1][c][v]);
                sum += d * d;
                s0 += std::pow(static_cast<double>(images[1][c][v].x), 2);
            }
        return glm::sqrt(sum / s0);
    };
    const glm::dvec4 of_whole = error(*whole);
    const glm::dvec4 of_half = error(*half);
    for (int p = 0; p < 4; ++p) {
        MESSAGE("s", p, ": ", 100 * of_whole[p], " %, symmetrized ", 100 * of_half[p], " % of s0");
        CHECK(of_whole[p] < 0.45 * of_half[p]);
    }
}
