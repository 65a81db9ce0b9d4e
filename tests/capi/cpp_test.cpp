// SPDX-License-Identifier: MIT
// Tests of nicol.hpp: ownership of handles, and failures as exceptions.
#include <doctest/doctest.h>

#include <nicol.hpp>
#include <vector>

static_assert(!std::is_copy_constructible_v<nicol::Scene> &&
              std::is_nothrow_move_constructible_v<nicol::Scene>);
// The handle of an object that is about to be released is no argument.
static_assert(std::is_convertible_v<const nicol::Scene&, nicol_scene> &&
              !std::is_convertible_v<nicol::Scene, nicol_scene>);

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

TEST_CASE("objects have methods, and are arguments of functions") {
    const auto context = nicol::Context::create();
    const auto scene = nicol::Scene::create(context);
    const auto mesh = nicol::Mesh::create_divided_sphere(context, 2);
    const auto grey = nicol::Material::create_diffuse(context, nullptr);
    auto instance = nicol::defaults(nicol_instance_init);
    instance.mesh = mesh;
    instance.material = grey;
    const std::uint32_t id = scene.add_instance(&instance);
    scene.set_environment(nicol::Environment::create_constant(context, nullptr).get(), nullptr, 2);

    std::vector<std::uint32_t> ids(scene.get_instance_count());
    scene.get_instance_ids(ids);
    CHECK(ids == std::vector{id});
    const auto [its_mesh, its_material, to_world] = scene.get_instance(id);
    CHECK(its_mesh.get_size() == mesh.get_size());
    CHECK(its_material != nullptr);
    CHECK(to_world[15] == 1);

    auto camera = nicol::defaults(nicol_camera_init);
    const double origin[] = {0, 0, 4}, target[] = {0, 0, 0}, up[] = {0, 1, 0};
    nicol::camera_look_at(&camera, origin, target, up);
    const auto image = nicol::Framebuffer::create(context, 4, 3, scene.get_channels());
    nicol::render_async(scene, &camera, nullptr, image).wait(NICOL_WAIT_FOREVER);
    CHECK(std::get<1>(image.get_size()) == 3);
    std::vector<float> s0(12);
    image.read(NICOL_PLANE_S0, 0, s0.data(), 0, 48);
    CHECK(s0[0] == doctest::Approx(2));

    const std::vector<double> even{1, 0, 0, 0}, up_and_down{0, 0, 1, 0, 0, -1};
    std::vector<double> stokes(8);
    nicol::psh_evaluate(0, 1, even, up_and_down, stokes);
    CHECK(stokes[4] == doctest::Approx(0.28209479));
}

TEST_CASE("a failure has its code and message, and leaves nothing to release") {
    try {
        (void)nicol::create<nicol::Mesh>(nicol_mesh_load, nullptr, "none.obj");
        FAIL("no exception");
    } catch (const nicol::Error& error) {
        CHECK(error.result() == NICOL_ERROR_INVALID_HANDLE);
        CHECK(std::string(error.what()) == nicol_last_error());
    }
    const nicol::Framebuffer none;
    CHECK(!none);
    CHECK_THROWS_AS(none.resize(2, 2), nicol::Error);
    CHECK_THROWS_AS((void)nicol::Mesh::load(nullptr, "none.obj"), nicol::Error);
    nicol_psh_sampling sampling = NICOL_PSH_SAMPLING_INIT;
    sampling.order = 2;
    const auto transform = nicol::create<nicol::PshTransform>(nicol_psh_transform_create, &sampling);
    std::uint32_t rows = 0, columns = 0;
    nicol::check(nicol_psh_transform_get_size(transform.get(), &rows, &columns));
    CHECK(rows == 5);
}
