// SPDX-License-Identifier: MIT
// Tests of object lifetimes: handles released in any order, by many threads, while other objects use them.
#include <numeric>
#include <thread>

#include "capi.hpp"

using namespace capi_test;

namespace {

// One live handle of each kind.
struct Connected {
    nicol_context context;
    nicol_environment environment = constant_light(context, {1});
    nicol_material material = diffuse(context, {0.5F});
    nicol_mesh mesh = rectangle(context);
    nicol_scene scene = empty_scene(context);
    nicol_framebuffer framebuffer = framebuffer_of(context, 4, 4, 1);

    void connect() const {
        OK(nicol_scene_set_environment(scene, environment, nullptr, 1));
        add(scene, mesh, material);
    }
};

// Release functions of a set of handles, by position.
std::vector<std::function<nicol_result()>> releases(const Connected& all) {
    return {[=] { return nicol_context_release(all.context); },
            [=] { return nicol_environment_release(all.environment); },
            [=] { return nicol_material_release(all.material); },
            [=] { return nicol_mesh_release(all.mesh); },
            [=] { return nicol_scene_release(all.scene); },
            [=] { return nicol_framebuffer_release(all.framebuffer); }};
}

}  // namespace

TEST_CASE("handles may be released in any order") {
    // Tests each of the 720 orders of six handles with few contexts. The context is retained except in every
    // 60th order, which destroys it.
    for (const nicol_backend backend : every_backend()) {
        CAPTURE(backend);
        nicol_context context = make_context(backend);
        std::vector<std::size_t> order(6);
        std::iota(order.begin(), order.end(), std::size_t{0});
        int count = 0;
        do {
            const bool last = ++count % 60 == 0;
            if (!last) OK(nicol_context_retain(context));
            const Connected all{context};
            if (count % 4 != 0) all.connect();
            if (last) {
                const nicol_camera camera = front_camera();
                OK(nicol_render(all.scene, &camera, nullptr, all.framebuffer));
            }
            for (const std::size_t i : order) OK(releases(all)[i]());
            if (last) context = make_context(backend);
        } while (std::next_permutation(order.begin(), order.end()));
        CHECK(count == 720);
        OK(nicol_context_release(context));
    }
}

TEST_CASE("a later object does not answer to a released handle") {
    const Owned context(make_context(NICOL_BACKEND_OSMESA));
    const nicol_mesh gone = rectangle(context);
    OK(nicol_mesh_release(gone));
    std::uint32_t vertices = 0, triangles = 0;
    for (int i = 0; i < 100; ++i) {
        const Owned later(rectangle(context));
        CHECK(nicol_mesh_get_size(gone, &vertices, &triangles) == NICOL_ERROR_INVALID_HANDLE);
    }
}

TEST_CASE("objects work on after their context and their parts were released") {
    for (const nicol_backend backend : every_backend()) {
        CAPTURE(backend);
        const Connected all{make_context(backend)};
        all.connect();
        OK(nicol_context_release(all.context));
        OK(nicol_environment_release(all.environment));
        OK(nicol_material_release(all.material));
        OK(nicol_mesh_release(all.mesh));
        const nicol_camera camera = front_camera();
        OK(nicol_render(all.scene, &camera, nullptr, all.framebuffer));
        OK(nicol_scene_release(all.scene));
        CHECK(read_plane(all.framebuffer, NICOL_PLANE_S0)[5] > 0);
        OK(nicol_framebuffer_release(all.framebuffer));
    }
}

TEST_CASE("objects of different contexts do not mix") {
    const nicol_context contexts[] = {make_context(NICOL_BACKEND_EGL), make_context(NICOL_BACKEND_OSMESA)};
    const Connected a{contexts[0]}, b{contexts[1]};
    std::uint32_t id = 77;
    const auto add_to_a = [&](nicol_mesh mesh, nicol_material material) {
        nicol_instance instance = NICOL_INSTANCE_INIT;
        instance.mesh = mesh;
        instance.material = material;
        return nicol_scene_add_instance(a.scene, &instance, &id);
    };
    const nicol_camera camera = front_camera();
    const std::vector<float> values{0.5F, 0.6F};
    const nicol_texture_image image = image_of_texels(values, 2, 1, 1, NICOL_TEXEL_FLOAT32);
    const Owned texture(make(nicol_texture_create_image, b.context, &image, nullptr));
    std::array<float, 4> pixel{};
    nicol_stokes_image picture = NICOL_STOKES_IMAGE_INIT;
    picture.width = picture.height = picture.channels = 1;
    picture.pixels = pixel.data();
    picture.byte_size = sizeof pixel;
    std::array<double, 2> texels{};
    nicol_gradient gradient = NICOL_GRADIENT_INIT;
    gradient.texture = texture;
    gradient.texels = texels.data();
    gradient.texels_count = texels.size();
    const auto foreign = NICOL_ERROR_INVALID_HANDLE;
    nicol_job job = marker<nicol_job>();
    nicol_material both = marker<nicol_material>();
    check_refused({
        {"different", [&] { return nicol_material_create_twosided(a.context, b.material, &both); }, foreign},
        {"contexts", [&] { return add_to_a(b.mesh, a.material); }, foreign},
        {"contexts", [&] { return add_to_a(a.mesh, b.material); }, foreign},
        {"contexts", [&] { return nicol_scene_set_environment(a.scene, b.environment, nullptr, 1); },
         foreign},
        {"contexts", [&] { return nicol_render(a.scene, &camera, nullptr, b.framebuffer); }, foreign},
        {"contexts", [&] { return nicol_render(b.scene, &camera, nullptr, a.framebuffer); }, foreign},
        {"contexts", [&] { return nicol_render_adjoint(a.scene, &camera, nullptr, &picture, &gradient); },
         foreign},
        {"contexts", [&] { return nicol_render_async(a.scene, &camera, nullptr, b.framebuffer, &job); },
         foreign},
    });
    CHECK(id == 77);
    CHECK((job == marker<nicol_job>() && both == marker<nicol_material>()));
    for (const Connected* all : {&a, &b}) {
        for (const auto& release : releases(*all)) OK(release());
    }
}

CONTEXT_TEST_CASE("threads may share and drop handles while others use them") {
    for (int round = 0; round < 10; ++round) {
        OK(nicol_context_retain(context));
        const Connected all{context};
        all.connect();
        const nicol_camera camera = front_camera();
        std::vector<std::string> wrong(4);
        std::vector<std::thread> threads;
        for (std::size_t t = 0; t < wrong.size(); ++t) {
            threads.emplace_back([&, t] {
                const auto expect_alive_or_gone = [&](nicol_result result) {
                    if (result != NICOL_OK && result != NICOL_ERROR_INVALID_HANDLE)
                        wrong[t] = nicol_last_error();
                };
                for (int n = 0; n < 3; ++n) {
                    expect_alive_or_gone(nicol_render(all.scene, &camera, nullptr, all.framebuffer));
                    std::uint32_t vertices = 0, triangles = 0;
                    expect_alive_or_gone(nicol_mesh_get_size(all.mesh, &vertices, &triangles));
                }
                // The first thread drops handles that the other threads still use.
                for (std::size_t i = 1; i < 6; ++i) expect_alive_or_gone(releases(all)[i]());
            });
        }
        for (std::thread& thread : threads) thread.join();
        for (const std::string& message : wrong) CHECK(message == "");
        for (std::size_t i = 1; i < 6; ++i) CHECK(releases(all)[i]() == NICOL_ERROR_INVALID_HANDLE);
        OK(nicol_context_release(context));
    }
}
