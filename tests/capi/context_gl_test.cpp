// SPDX-License-Identifier: MIT
// Making contexts, what they say of themselves, and several of them at once.
#include <atomic>
#include <thread>

#include "capi.hpp"

using namespace capi_test;

TEST_CASE("a context says what it is") {
    on_every_backend([](nicol_context context) {
        nicol_context_info info = NICOL_CONTEXT_INFO_INIT;
        OK(nicol_context_get_info(context, &info));
        CHECK((info.backend == NICOL_BACKEND_EGL || info.backend == NICOL_BACKEND_OSMESA));
        CHECK(info.software <= 1);
        CHECK(info.threads == 2);
        for (const char* text : {info.renderer, info.vendor, info.version}) {
            REQUIRE(text != nullptr);
            CHECK(text[0] != '\0');
        }
        CHECK(std::string(info.version).find('.') != std::string::npos);
    });
    for (const nicol_backend backend : every_backend) {
        const Owned context(make_context(backend));
        nicol_context_info info = NICOL_CONTEXT_INFO_INIT;
        OK(nicol_context_get_info(context, &info));
        CHECK(info.backend == backend);
        if (backend == NICOL_BACKEND_OSMESA) CHECK(info.software == 1);
    }
}

TEST_CASE("a context by default uses a thread a core") {
    Owned<nicol_context> context;
    OK(nicol_context_create(nullptr, &context));
    nicol_context_info info = NICOL_CONTEXT_INFO_INIT;
    OK(nicol_context_get_info(context, &info));
    CHECK(info.threads >= 1);
    CHECK(info.backend != NICOL_BACKEND_AUTOMATIC);
}

TEST_CASE("options out of range are refused by name") {
    nicol_context context = marker<nicol_context>();
    nicol_context_options options = NICOL_CONTEXT_OPTIONS_INIT;
    for (const nicol_backend backend : {3U, UINT32_MAX}) {
        options.backend = backend;
        FAILS(nicol_context_create(&options, &context), NICOL_ERROR_INVALID_ARGUMENT, "backend");
    }
    options = NICOL_CONTEXT_OPTIONS_INIT;
    options.threads = UINT32_MAX;
    FAILS(nicol_context_create(&options, &context), NICOL_ERROR_INVALID_ARGUMENT, "threads");
    options = NICOL_CONTEXT_OPTIONS_INIT;
    options.backend = NICOL_BACKEND_OSMESA;
    options.device = 1;
    FAILS(nicol_context_create(&options, &context), NICOL_ERROR_INVALID_ARGUMENT, "device");
    options.backend = NICOL_BACKEND_EGL;
    for (const std::uint32_t device : {999U, UINT32_MAX}) {
        options.device = device;
        FAILS(nicol_context_create(&options, &context), NICOL_ERROR_INVALID_ARGUMENT, "device");
    }
    CHECK(context == marker<nicol_context>());
}

TEST_CASE("contexts come and go twenty times") {
    for (int cycle = 0; cycle < 20; ++cycle) {
        const Owned context(make_context(every_backend[cycle % 2]));
        {
            const Stage stage(context);
            if (cycle % 4 < 2) {
                stage.render();
                CHECK(read_plane(stage.framebuffer, NICOL_PLANE_S0)[0] > 0);
            }
        }
    }
}

TEST_CASE("an EGL and an OSMesa context render at once, from a thread each") {
    const nicol_context contexts[] = {make_context(NICOL_BACKEND_EGL), make_context(NICOL_BACKEND_OSMESA)};
    {
        const Stage stages[] = {Stage(contexts[0]), Stage(contexts[1])};
        std::vector<float> alone[2];
        for (std::size_t i = 0; i < 2; ++i) {
            stages[i].render();
            alone[i] = read_all(stages[i].framebuffer);
        }
        std::atomic<int> different = 0, failed = 0;
        std::vector<std::thread> threads;
        for (std::size_t i = 0; i < 2; ++i) {
            threads.emplace_back([&, i] {
                const Stage& stage = stages[i];
                std::vector<float> pixels(24 * 16 * 4);
                for (int round = 0; round < 30; ++round) {
                    if (nicol_render(stage.scene, &stage.camera, nullptr, stage.framebuffer) != NICOL_OK)
                        ++failed;
                    if (nicol_framebuffer_read(stage.framebuffer, NICOL_PLANE_STOKES, 0, pixels.data(), 0,
                                               pixels.size() * sizeof(float)) != NICOL_OK)
                        ++failed;
                    if (!std::equal(pixels.begin(), pixels.end(), alone[i].begin())) ++different;
                }
            });
        }
        for (std::thread& thread : threads) thread.join();
        CHECK(failed == 0);
        CHECK(different == 0);
    }
    for (const nicol_context context : contexts) OK(nicol_context_release(context));
}

TEST_CASE("threads that share a context take turns") {
    on_every_backend([](nicol_context context) {
        const Stage a(context), b(context);
        a.render();
        const std::vector<float> alone = read_all(a.framebuffer);
        std::atomic<int> different = 0, failed = 0;
        std::vector<std::thread> threads;
        for (const Stage* stage : {&a, &b, &a, &b}) {
            threads.emplace_back([&, stage] {
                std::vector<float> pixels(24 * 16 * 4);
                for (int round = 0; round < 10; ++round) {
                    if (nicol_render(stage->scene, &stage->camera, nullptr, stage->framebuffer) != NICOL_OK)
                        ++failed;
                    if (nicol_framebuffer_read(stage->framebuffer, NICOL_PLANE_STOKES, 0, pixels.data(), 0,
                                               pixels.size() * sizeof(float)) != NICOL_OK)
                        ++failed;
                    if (!std::equal(pixels.begin(), pixels.end(), alone.begin())) ++different;
                }
            });
        }
        for (std::thread& thread : threads) thread.join();
        CHECK(failed == 0);
        CHECK(different == 0);
    });
}

TEST_CASE("a context made on one thread is used and released on others") {
    for (const nicol_backend backend : every_backend) {
        nicol_context context = nullptr;
        std::thread([&] { context = make_context(backend); }).join();
        std::thread([&] {
            const Stage stage(context);
            stage.render();
            CHECK(read_plane(stage.framebuffer, NICOL_PLANE_S0)[0] > 0);
        }).join();
        std::thread([&] { CHECK(nicol_context_release(context) == NICOL_OK); }).join();
    }
}
