// SPDX-License-Identifier: MIT
// The reference method through the interface, and images of the luminance.
#include <cmath>

#include "capi.hpp"

using namespace capi_test;

namespace {

nicol_render_options reference(std::int32_t samples, std::uint64_t seed = 0) {
    nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
    options.method = NICOL_METHOD_REFERENCE;
    options.samples = samples;
    options.seed = seed;
    return options;
}

std::vector<float> traced(const Stage& stage, std::int32_t samples, std::uint64_t seed = 0) {
    const nicol_render_options options = reference(samples, seed);
    return stage.image(options);
}

double mean_difference(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0, size = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
        size += std::abs(static_cast<double>(b[i]));
    }
    return sum / size;
}

}  // namespace

TEST_CASE("the reference method shows what the factored one shows, and what it took") {
    on_every_stage([](const Stage& stage) {
        const std::vector<float> factored = stage.image();
        CHECK(statistics_of(stage.framebuffer).camera_rays == 0);
        const std::vector<float> image = traced(stage, 256);
        CHECK(image != factored);
        // Edges are smoothed by one and not by the other.
        CHECK(mean_difference(image, factored) < 0.05);
        const nicol_statistics statistics = statistics_of(stage.framebuffer);
        CHECK(statistics.camera_rays == 24 * 16 * 256);
        CHECK(statistics.shadow_rays > 0);
        CHECK(statistics.trace_ms > 0);
        CHECK(statistics.bake_ms > 0);
        CHECK(statistics.order == 0);
        CHECK(statistics.project_ms == 0);
        CHECK(statistics.shade_ms == 0);
        CHECK(statistics.texture_bytes >= 24 * 16 * 3 * 16);
        std::uint32_t vertices = 0, triangles = 0;
        OK(nicol_mesh_get_size(stage.mesh, &vertices, &triangles));
        CHECK(statistics.vertices == vertices);
        CHECK(statistics.triangles == triangles);
        // 0 asks for 256, and what was drawn before does not shine through.
        CHECK(traced(stage, 0) == image);
        CHECK(stage.image() == factored);
    });
}

TEST_CASE("a framebuffer of one channel shows the luminance of three, by every method") {
    on_every_stage([](const Stage& stage) {
        const Owned grey(framebuffer_of(stage.context, 24, 16, 1));
        for (const nicol_method method : {NICOL_METHOD_FACTORED, NICOL_METHOD_REFERENCE}) {
            nicol_render_options options = reference(4);
            options.method = method;
            OK(stage.try_render(options));
            OK(nicol_render(stage.scene, &stage.camera, &options, grey));
            const std::vector<float> colours = read_all(stage.framebuffer);
            const std::vector<float> luminance = read_all(grey);
            REQUIRE(colours.size() == 3 * luminance.size());
            for (std::size_t i = 0; i < luminance.size(); ++i) {
                const double wanted = 0.2126 * colours[i] + 0.7152 * colours[luminance.size() + i] +
                                      0.0722 * colours[2 * luminance.size() + i];
                CHECK(luminance[i] == doctest::Approx(wanted).epsilon(1e-5));
            }
            CHECK(statistics_of(grey).camera_rays == statistics_of(stage.framebuffer).camera_rays);
            CHECK(statistics_of(grey).order == statistics_of(stage.framebuffer).order);
        }
    });
}
