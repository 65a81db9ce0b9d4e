// SPDX-License-Identifier: MIT
// Where relight and shade run, as callers choose it.
#include <algorithm>
#include <cmath>

#include "capi.hpp"

using namespace capi_test;

namespace {

std::vector<float> render_by(const Stage& stage, nicol_executor executor, nicol_render_options options) {
    options.executor = executor;
    OK(nicol_render(stage.scene, &stage.camera, &options, stage.framebuffer));
    return read_all(stage.framebuffer);
}

}  // namespace

TEST_CASE("threads and compute shaders make the same image, and statistics tell them apart") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        // A second cube hides the sky from the first.
        add(stage.scene, stage.mesh, stage.material, placed(0.9, 0.3, 0.2, 0.4));
        for (const nicol_method method : {NICOL_METHOD_FACTORED, NICOL_METHOD_DENSE}) {
            for (const std::int32_t order_low : {1, 4}) {
                CAPTURE(method);
                CAPTURE(order_low);
                nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
                options.method = method;
                options.order_low = order_low;
                options.bake_directions = 256;
                const std::vector<float> threads = render_by(stage, NICOL_EXECUTOR_CPU, options);
                CHECK(statistics_of(stage.framebuffer).compute == 0);
                const std::vector<float> shaders = render_by(stage, NICOL_EXECUTOR_COMPUTE, options);
                CHECK(statistics_of(stage.framebuffer).compute == 1);
                float largest = 0, difference = 0;
                for (std::size_t i = 0; i < threads.size(); ++i) {
                    largest = std::max(largest, std::abs(threads[i]));
                    difference = std::max(difference, std::abs(threads[i] - shaders[i]));
                }
                CHECK(largest > 0.1F);
                CHECK(difference <= 1e-5F * largest);
            }
        }
    });
}

TEST_CASE("the automatic executor is threads where OpenGL runs on the CPU") {
    on_every_backend([](nicol_context context) {
        nicol_context_info info = NICOL_CONTEXT_INFO_INIT;
        OK(nicol_context_get_info(context, &info));
        const Stage stage(context);
        stage.render();
        const std::vector<float> image = read_all(stage.framebuffer);
        CHECK(statistics_of(stage.framebuffer).compute == (info.software != 0 ? 0U : 1U));
        const nicol_executor same = info.software != 0 ? NICOL_EXECUTOR_CPU : NICOL_EXECUTOR_COMPUTE;
        CHECK(render_by(stage, same, NICOL_RENDER_OPTIONS_INIT) == image);
    });
}

TEST_CASE("executors out of range are refused by name, and callers of older versions get the automatic one") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        stage.render();
        const std::vector<float> before = read_all(stage.framebuffer);
        const std::uint32_t compute = statistics_of(stage.framebuffer).compute;
        nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
        for (const std::uint32_t bad : {3U, 77U, UINT32_MAX}) {
            options.executor = bad;
            FAILS(nicol_render(stage.scene, &stage.camera, &options, stage.framebuffer),
                  NICOL_ERROR_INVALID_ARGUMENT,
                  "executor is " + std::to_string(bad) + "; it must be one of NICOL_EXECUTOR_");
        }
        CHECK(read_all(stage.framebuffer) == before);
        // Where the struct ends before it, whatever lies there is not read.
        options.executor = NICOL_EXECUTOR_COMPUTE;
        options.struct_size = offsetof(nicol_render_options, executor);
        OK(nicol_render(stage.scene, &stage.camera, &options, stage.framebuffer));
        CHECK(statistics_of(stage.framebuffer).compute == compute);
        CHECK(read_all(stage.framebuffer) == before);
    });
}

TEST_CASE("high orders are looked up where callers ask for it") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        const auto render_at = [&](nicol_high_orders_at where, nicol_high_orders form) {
            nicol_render_options options = NICOL_RENDER_OPTIONS_INIT;
            options.order_low = -1;  // the sky has orders 1 and 2 above that
            options.bake_directions = 256;
            options.high_orders = form;
            options.high_orders_at = where;
            OK(nicol_render(stage.scene, &stage.camera, &options, stage.framebuffer));
            return read_all(stage.framebuffer);
        };
        const std::vector<float> vertices = render_at(NICOL_HIGH_ORDERS_AT_VERTICES, NICOL_HIGH_ORDERS_SPLIT);
        CHECK(statistics_of(stage.framebuffer).high_orders_at == NICOL_HIGH_ORDERS_AT_VERTICES);
        const std::vector<float> pixels = render_at(NICOL_HIGH_ORDERS_AT_PIXELS, NICOL_HIGH_ORDERS_SPLIT);
        CHECK(statistics_of(stage.framebuffer).high_orders_at == NICOL_HIGH_ORDERS_AT_PIXELS);
        CHECK(pixels != vertices);
        float largest = 0, difference = 0;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            largest = std::max(largest, std::abs(vertices[i]));
            difference = std::max(difference, std::abs(vertices[i] - pixels[i]));
        }
        CHECK(difference < 0.01F * largest);  // a cube of many vertices
        render_at(NICOL_HIGH_ORDERS_AT_PIXELS, NICOL_HIGH_ORDERS_NONE);
        CHECK(statistics_of(stage.framebuffer).high_orders_at == NICOL_HIGH_ORDERS_AT_AUTOMATIC);
    });
}
