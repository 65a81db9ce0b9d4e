// SPDX-License-Identifier: MIT
// Tests of a host's memory monitor: what it is told, and calls whose memory it refuses.
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "capi.hpp"

using namespace capi_test;

namespace {

constexpr std::uint32_t width = 24, height = 16;

/// Monitor that adds up, and refuses one question.
struct Monitor {
    std::atomic<std::int64_t> sum{0};
    std::atomic<int> questions{0};
    int refused = -1;  ///< number of the question, from 0

    static std::int32_t tell(void* user, std::int64_t bytes) {
        auto& self = *static_cast<Monitor*>(user);
        if (bytes > 0 && self.questions++ == self.refused) return 0;
        self.sum += bytes;
        return 1;
    }
    nicol_context_options options(nicol_backend backend) {
        nicol_context_options made = two_threads(backend);
        made.memory = tell;
        made.memory_user = this;
        return made;
    }
};

nicol_render_options small_render(nicol_executor executor = NICOL_EXECUTOR_CPU) {
    nicol_render_options options = plain_options();
    options.executor = executor;
    options.order_low = 2;
    options.order_high = 9;
    options.bake_directions = 256;
    options.aovs = NICOL_AOV_DEPTH;
    return options;
}

/// Objects of a picture, which steps make one after the other.
struct Picture {
    Owned<nicol_context> context;
    Owned<nicol_scene> scene;
    Owned<nicol_mesh> mesh;
    Owned<nicol_texture> texture;
    Owned<nicol_environment> light;
    Owned<nicol_material> material;
    Owned<nicol_framebuffer> framebuffer;
    nicol_camera camera = front_camera();
    std::vector<float> image_of_light = std::vector<float>(std::size_t{8} * 4 * 3, 0.5F);

    /// Returns the calls of a picture, each of which may be repeated after a failure.
    std::vector<std::function<nicol_result()>> steps(const nicol_context_options& options,
                                                     nicol_executor executor) {
        return {[&] { return nicol_context_create(&options, &context); },
                [&] {
                    const nicol_image image = image_of(image_of_light, 8, 4, 3, 1);
                    return nicol_environment_create_image(context, &image, &light);
                },
                [&] {
                    static const std::vector<float> texels(std::size_t{4} * 4 * 3, 0.5F);
                    const nicol_texture_image image = image_of_texels(texels, 4, 4, 3, NICOL_TEXEL_FLOAT32);
                    return nicol_texture_create_image(context, &image, nullptr, &texture);
                },
                [&] { return nicol_mesh_create_cube(context, &mesh); },
                [&] { return nicol_material_create_diffuse(context, nullptr, &material); },
                [&] { return nicol_framebuffer_create(context, width, height, 3, &framebuffer); },
                [&] {
                    *&scene = simple_scene(context, light, mesh, material);
                    return NICOL_OK;
                },
                [&, executor] {
                    const nicol_render_options render = small_render(executor);
                    return nicol_render(scene, &camera, &render, framebuffer);
                },
                [&, executor] {
                    nicol_render_options render = small_render(executor);
                    render.pixel_samples = 4;
                    render.shade_at = NICOL_SHADE_AT_PIXELS;
                    return nicol_render(scene, &camera, &render, framebuffer);
                }};
    }
};

}  // namespace

TEST_CASE("a memory monitor knows all large blocks, and its sum is 0 at the end") {
    for (const nicol_backend backend : every_backend()) {
        CAPTURE(backend);
        Monitor monitor;
        const nicol_context_options options = monitor.options(backend);
        {
            const Owned context(make(nicol_context_create, &options));
            CHECK(monitor.sum == 0);
            {
                const Owned mesh(sphere(context));
                std::uint32_t vertices = 0, triangles = 0;
                OK(nicol_mesh_get_size(mesh, &vertices, &triangles));
                CHECK(monitor.sum >= std::int64_t{24} * vertices + std::int64_t{12} * triangles);
            }
            CHECK(monitor.sum == 0);
            const Owned scene(make(nicol_scene_load, context, NICOL_TEST_ASSETS "/snail_hdr.xml",
                                   static_cast<const char* const*>(nullptr), 0U));
            const std::int64_t of_scene = monitor.sum;
            CHECK(of_scene > 500'000);
            {
                const Owned framebuffer(framebuffer_of(context, width, height, 3));
                nicol_camera camera = NICOL_CAMERA_INIT;
                OK(nicol_scene_get_camera(scene, &camera));
                nicol_render_options render = small_render();
                for (const std::uint32_t samples : {1U, 4U, 1U}) {
                    render.pixel_samples = samples;
                    const Owned job(make(nicol_render_async, scene, &camera, &render, framebuffer));
                    OK(nicol_job_wait(job, NICOL_WAIT_FOREVER));
                    const nicol_statistics kept = statistics_of(framebuffer);
                    nicol_context_info info = NICOL_CONTEXT_INFO_INIT;
                    OK(nicol_context_get_info(context, &info));
                    CHECK(monitor.sum ==
                          of_scene + static_cast<std::int64_t>(info.device_bytes + kept.response_bytes +
                                                               kept.visibility_bytes + kept.transfer_bytes));
                }
                // The reference method keeps nothing.
                const std::int64_t before = monitor.sum;
                render.method = NICOL_METHOD_REFERENCE;
                render.samples = 1;
                OK(nicol_render(scene, &camera, &render, framebuffer));
                CHECK(monitor.sum <= before + std::int64_t{width} * height * 3 * 16);
            }
        }
        CHECK(monitor.sum == 0);
    }
}

TEST_CASE("a refusal at any question fails one call, which works when it is repeated") {
    for (const nicol_executor executor : {NICOL_EXECUTOR_CPU, NICOL_EXECUTOR_COMPUTE}) {
        std::vector<float> expected;
        int failures = 0;
        for (int refused = -1;; ++refused) {
            CAPTURE(refused);
            Monitor monitor{.refused = refused};
            const nicol_context_options options = monitor.options(NICOL_BACKEND_EGL);
            {
                Picture picture;
                for (const auto& step : picture.steps(options, executor)) {
                    const std::int64_t before = monitor.sum;
                    const nicol_result result = step();
                    if (result == NICOL_OK) continue;
                    ++failures;
                    CHECK(result == NICOL_ERROR_OUT_OF_MEMORY);
                    CHECK(std::string(nicol_last_error()).find("monitor") != std::string::npos);
                    CHECK(monitor.sum >= before);
                    OK(step());
                }
                const std::vector<float> image = read_all(picture.framebuffer);
                if (expected.empty()) expected = image;
                CHECK(image == expected);
            }
            CHECK(monitor.sum == 0);
            if (refused >= 0 && monitor.questions <= refused) break;
        }
        CHECK(failures > 15);
        MESSAGE(failures, " refusals");
    }
}
