// SPDX-License-Identifier: MIT
// The reference method through the interface, and images of the luminance.
#include <cmath>
#include <cstring>
#include <thread>

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
    OK(nicol_render(stage.scene, &stage.camera, &options, stage.framebuffer));
    return read_all(stage.framebuffer);
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
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        stage.render();
        const std::vector<float> factored = read_all(stage.framebuffer);
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
        stage.render();
        CHECK(read_all(stage.framebuffer) == factored);
    });
}

TEST_CASE("a seed gives one image, whatever the threads and the backend") {
    std::vector<std::vector<float>> images;
    for (const nicol_backend backend : every_backend) {
        for (const std::uint32_t threads : {1U, 3U}) {
            nicol_context_options options = NICOL_CONTEXT_OPTIONS_INIT;
            options.backend = backend;
            options.threads = threads;
            Owned<nicol_context> context;
            OK(nicol_context_create(&options, &context));
            {
                const Stage stage(context);
                images.push_back(traced(stage, 4, 7));
                CHECK(traced(stage, 4, 8) != images.front());
                CHECK(traced(stage, 4, std::uint64_t{7} << 32) != images.front());
            }
        }
    }
    for (const auto& image : images) CHECK(image == images.front());
}

TEST_CASE("reference options that cannot be are refused, and the image stays") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        const std::vector<float> before = traced(stage, 2);
        const auto render = [&](const nicol_render_options& options) {
            return nicol_render(stage.scene, &stage.camera, &options, stage.framebuffer);
        };
        for (const std::int32_t bad : {-1, INT32_MIN, (1 << 20) + 1, INT32_MAX})
            FAILS(render(reference(bad)), NICOL_ERROR_INVALID_ARGUMENT, "samples");
        nicol_render_options options = reference(1);
        options.reserved = 1;
        FAILS(render(options), NICOL_ERROR_INVALID_ARGUMENT, "reserved");
        CHECK(read_all(stage.framebuffer) == before);
        CHECK(statistics_of(stage.framebuffer).camera_rays == 24 * 16 * 2);
    });
}

TEST_CASE("a reference render tells its progress and can be cancelled") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        const std::vector<float> before = traced(stage, 2);
        struct Watch {
            int calls = 0;
            int stop_at = 0;
            double last = 0;
            std::thread::id caller = std::this_thread::get_id();
        } watch;
        nicol_render_options options = reference(4096);
        options.progress_user = &watch;
        options.progress = [](void* user, const char* verb, double fraction) -> std::int32_t {
            Watch& w = *static_cast<Watch*>(user);
            CHECK(std::strcmp(verb, "trace") == 0);
            CHECK(fraction >= w.last);
            CHECK(fraction <= 1);
            CHECK(std::this_thread::get_id() == w.caller);
            w.last = fraction;
            return ++w.calls != w.stop_at;
        };
        for (const int stop_at : {1, 2}) {
            watch = {};
            watch.stop_at = stop_at;
            FAILS(nicol_render(stage.scene, &stage.camera, &options, stage.framebuffer),
                  NICOL_ERROR_CANCELLED, "progress");
            CHECK(watch.calls == stop_at);
            CHECK(read_all(stage.framebuffer) == before);
            CHECK(statistics_of(stage.framebuffer).camera_rays == 24 * 16 * 2);
        }
    });
}

TEST_CASE("more channels than are drawn at once") {
    on_every_backend([](nicol_context context) {
        const std::vector<float> light = {1, 2, 3, 4, 5, 6, 7};
        const Owned environment(constant_light(context, light));
        const Owned scene(empty_scene(context));
        OK(nicol_scene_set_environment(scene, environment, nullptr, 0));
        const Owned framebuffer(framebuffer_of(context, 3, 2, 7));
        const nicol_camera camera = front_camera();
        const nicol_render_options options = reference(1);
        OK(nicol_render(scene, &camera, &options, framebuffer));
        for (std::uint32_t c = 0; c < 7; ++c)
            for (const float s0 : read_plane(framebuffer, NICOL_PLANE_S0, c))
                CHECK(s0 == doctest::Approx(light[c]));
    });
}

TEST_CASE("a framebuffer of one channel shows the luminance of three, by every method") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        const Owned grey(framebuffer_of(context, 24, 16, 1));
        for (const nicol_method method : {NICOL_METHOD_FACTORED, NICOL_METHOD_REFERENCE}) {
            nicol_render_options options = reference(4);
            options.method = method;
            OK(nicol_render(stage.scene, &stage.camera, &options, stage.framebuffer));
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
