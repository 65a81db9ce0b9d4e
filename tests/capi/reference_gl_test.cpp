// SPDX-License-Identifier: MIT
// Tests of the reference method through the C interface.
#include "capi.hpp"

using namespace capi_test;

namespace {

nicol_render_options reference(std::uint32_t samples) {
    nicol_render_options options = plain_options();
    options.method = NICOL_METHOD_REFERENCE;
    options.samples = samples;
    return options;
}

}  // namespace

STAGE_TEST_CASE("the reference method shows what the factored one shows, and what it took") {
    const std::vector<float> factored = stage.image();
    CHECK(statistics_of(stage.framebuffer).camera_rays == 0);
    const std::vector<float> image = stage.image(reference(256));
    CHECK(image != factored);
    // The two methods smooth edges differently, so the test compares the mean difference with the mean value.
    double apart = 0, size = 0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        apart += std::abs(double(image[i]) - double(factored[i]));
        size += std::abs(double(factored[i]));
    }
    CHECK(apart < 0.05 * size);
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
    // 256 samples are the default, and an earlier image does not show through.
    nicol_render_options defaults = NICOL_RENDER_OPTIONS_INIT;
    defaults.method = NICOL_METHOD_REFERENCE;
    CHECK(stage.image(defaults) == image);
    CHECK(stage.image() == factored);
}

STAGE_TEST_CASE(
    "the reference and the factored method follow light to max_depth, and the dense method refuses it") {
    nicol_render_options options = reference(4);
    const std::vector<float> direct = stage.image(options);
    options.max_depth = 2;
    CHECK(stage.image(options) == direct);
    options.max_depth = 1;
    CHECK(stage.image(options) != direct);
    for (const std::int32_t depth : {3, NICOL_DEPTH_UNLIMITED}) {
        options.max_depth = depth;
        OK(stage.try_render(options));
    }
    options.shadows = 0;
    REFUSES(stage.try_render(options), "shadows");
    for (const nicol_method method : {NICOL_METHOD_FACTORED, NICOL_METHOD_DENSE}) {
        options = plain_options();
        options.method = method;
        options.max_depth = 2;
        OK(stage.try_render(options));
        options.max_depth = 1;
        FAILS(stage.try_render(options), NICOL_ERROR_UNSUPPORTED, "max_depth is 1");
        options.max_depth = NICOL_DEPTH_UNLIMITED;
        if (method == NICOL_METHOD_DENSE) {
            FAILS(stage.try_render(options), NICOL_ERROR_UNSUPPORTED, "max_depth is unlimited");
            continue;
        }
        OK(stage.try_render(options));
        options.shadows = 0;
        REFUSES(stage.try_render(options), "shadows");
    }
}
