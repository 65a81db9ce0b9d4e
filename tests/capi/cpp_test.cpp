// SPDX-License-Identifier: MIT
// Tests of nicol.hpp: ownership of handles, and failures as exceptions.
#include <doctest/doctest.h>

#include <nicol.hpp>
#include <vector>

static_assert(!std::is_copy_constructible_v<nicol::Scene> &&
              std::is_nothrow_move_constructible_v<nicol::Scene>);

TEST_CASE("an image by handles that release themselves") {
    auto context = nicol::create<nicol::Context>(nicol_context_create, nullptr);
    const auto light =
        nicol::create<nicol::Environment>(nicol_environment_create_constant, context.get(), nullptr);
    const auto scene = nicol::create<nicol::Scene>(nicol_scene_create, context.get());
    nicol::check(nicol_scene_set_environment(scene.get(), light.get(), nullptr, 1));
    const auto framebuffer =
        nicol::create<nicol::Framebuffer>(nicol_framebuffer_create, context.get(), 4u, 3u, 1u);
    const nicol::Context kept = std::move(context);
    CHECK(context == nullptr);
    const auto camera = nicol::defaults(nicol_camera_init);
    nicol::check(nicol_render(scene.get(), &camera, nullptr, framebuffer.get()));
    std::vector<float> s0(12);
    nicol::check(nicol_framebuffer_read(framebuffer.get(), NICOL_PLANE_S0, 0, s0.data(), 0, 48));
    for (const float value : s0) CHECK(value == doctest::Approx(1));
}

TEST_CASE("a failure has its code and message, and leaves nothing to release") {
    try {
        (void)nicol::create<nicol::Mesh>(nicol_mesh_load, nullptr, "none.obj");
        FAIL("no exception");
    } catch (const nicol::Error& error) {
        CHECK(error.result() == NICOL_ERROR_INVALID_HANDLE);
        CHECK(std::string(error.what()) == nicol_last_error());
    }
    nicol_psh_sampling sampling = NICOL_PSH_SAMPLING_INIT;
    sampling.order = 2;
    const auto transform = nicol::create<nicol::PshTransform>(nicol_psh_transform_create, &sampling);
    std::uint32_t rows = 0, columns = 0;
    nicol::check(nicol_psh_transform_get_size(transform.get(), &rows, &columns));
    CHECK(rows == 5);
}
