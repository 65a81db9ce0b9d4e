// SPDX-License-Identifier: MIT
// Scenes that change: instances removed, asked about, given other materials.
#include <array>
#include <cmath>
#include <thread>

#include "capi.hpp"

using namespace capi_test;

namespace {

std::vector<std::uint32_t> ids_of(nicol_scene scene) {
    std::uint32_t count = 99;
    OK(nicol_scene_get_instance_count(scene, &count));
    std::vector<std::uint32_t> ids(count, 99);
    OK(nicol_scene_get_instance_ids(scene, ids.data(), count));
    return ids;
}

nicol_material grey(nicol_context context, float reflectance) {
    nicol_material material = diffuse(context, {reflectance});
    return material;
}

// What a scene made of the same instances from the start looks like.
std::vector<float> fresh(nicol_context context, const Stage& stage, nicol_scene like) {
    nicol_scene scene = nullptr;
    OK(nicol_scene_create(context, &scene));
    OK(nicol_scene_set_environment(scene, stage.environment, nullptr, 0));
    for (const std::uint32_t id : ids_of(like)) {
        Owned<nicol_mesh> mesh;
        Owned<nicol_material> material;
        Matrix at{};
        OK(nicol_scene_get_instance(like, id, &mesh, &material, at.rows));
        add(scene, mesh, material, at);
    }
    nicol_framebuffer framebuffer = nullptr;
    OK(nicol_framebuffer_create(context, 24, 16, 3, &framebuffer));
    OK(nicol_render(scene, &stage.camera, nullptr, framebuffer));
    std::vector<float> image = read_all(framebuffer);
    OK(nicol_framebuffer_release(framebuffer));
    OK(nicol_scene_release(scene));
    return image;
}

}  // namespace

TEST_CASE("ids of removed instances are not given again, and those of others stay") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);  // has instance 0
        const std::uint32_t second = add(stage.scene, stage.mesh, stage.material, placed(1, 0, 0, 0.3));
        const std::uint32_t third = add(stage.scene, stage.mesh, stage.material, placed(-1, 0, 0, 0.3));
        CHECK(ids_of(stage.scene) == std::vector<std::uint32_t>{0, 1, 2});
        OK(nicol_scene_remove_instance(stage.scene, second));
        CHECK(ids_of(stage.scene) == std::vector<std::uint32_t>{0, 2});
        stage.render();
        CHECK(read_all(stage.framebuffer) == fresh(context, stage, stage.scene));

        FAILS(nicol_scene_remove_instance(stage.scene, second), NICOL_ERROR_INVALID_ARGUMENT, "instance 1");
        FAILS(nicol_scene_set_transform(stage.scene, second, placed(0, 0, 0).rows),
              NICOL_ERROR_INVALID_ARGUMENT, "removed");
        FAILS(nicol_scene_set_material(stage.scene, second, stage.material), NICOL_ERROR_INVALID_ARGUMENT,
              "instance 1");
        FAILS(nicol_scene_remove_instance(stage.scene, 3), NICOL_ERROR_INVALID_ARGUMENT, "instance 3");
        OK(nicol_scene_remove_instance(stage.scene, third));
        CHECK(add(stage.scene, stage.mesh, stage.material, placed(0, 1, 0, 0.3)) == 3);
        OK(nicol_scene_remove_instance(stage.scene, 0));
        OK(nicol_scene_remove_instance(stage.scene, 3));
        CHECK(ids_of(stage.scene).empty());
        OK(nicol_scene_get_instance_ids(stage.scene, nullptr, 0));
        stage.render();
        CHECK(read_all(stage.framebuffer) == fresh(context, stage, stage.scene));
    });
}

TEST_CASE("an instance tells what it is made of") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        const Matrix at = placed(1, 2, 3, 0.5);
        nicol_material material = grey(context, 0.3F);
        const std::uint32_t id = add(stage.scene, stage.mesh, material, at);
        OK(nicol_material_release(material));  // the scene keeps it

        nicol_mesh mesh = nullptr;
        Matrix told{};
        OK(nicol_scene_get_instance(stage.scene, id, &mesh, &material, told.rows));
        CHECK(std::equal(at.rows, at.rows + 16, told.rows));
        std::uint32_t vertices = 0, triangles = 0;
        OK(nicol_mesh_get_size(mesh, &vertices, &triangles));
        std::uint32_t all_vertices = 0, all_triangles = 0;
        OK(nicol_mesh_get_size(stage.mesh, &all_vertices, &all_triangles));
        CHECK(vertices == all_vertices);
        CHECK(triangles == all_triangles);
        OK(nicol_scene_remove_instance(stage.scene, id));
        // They live as long as their handles.
        CHECK(add(stage.scene, mesh, material, at) == id + 1);
        OK(nicol_mesh_release(mesh));
        OK(nicol_material_release(material));
        OK(nicol_scene_get_instance(stage.scene, id + 1, nullptr, nullptr, nullptr));

        mesh = marker<nicol_mesh>();
        material = marker<nicol_material>();
        const Matrix before = told;
        FAILS(nicol_scene_get_instance(stage.scene, id, &mesh, &material, told.rows),
              NICOL_ERROR_INVALID_ARGUMENT, "removed");
        CHECK(mesh == marker<nicol_mesh>());
        CHECK(material == marker<nicol_material>());
        CHECK(std::equal(before.rows, before.rows + 16, told.rows));
    });
}

TEST_CASE("counts and ids are refused where they do not fit") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        std::array<std::uint32_t, 2> ids = {7, 7};
        FAILS(nicol_scene_get_instance_ids(stage.scene, ids.data(), 2), NICOL_ERROR_INVALID_ARGUMENT,
              "count is 2");
        FAILS(nicol_scene_get_instance_ids(stage.scene, ids.data(), 0), NICOL_ERROR_INVALID_ARGUMENT,
              "count is 0");
        FAILS(nicol_scene_get_instance_ids(stage.scene, nullptr, 1), NICOL_ERROR_INVALID_ARGUMENT, "ids");
        CHECK(ids == std::array<std::uint32_t, 2>{7, 7});
    });
}

TEST_CASE("a material is swapped for one that fits the others' channels") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        const std::uint32_t id = add(stage.scene, stage.mesh, stage.material, placed(0.6, 0.5, 0.5, 0.3));
        stage.render();
        const nicol_statistics first = statistics_of(stage.framebuffer);
        CHECK(first.lights_projected == 1);
        CHECK(first.vertices_traced == first.vertices);
        CHECK(first.vertices_relit == first.vertices);
        CHECK(first.matrices_baked == 0);

        const nicol_material other = grey(context, 0.2F);
        OK(nicol_scene_set_material(stage.scene, id, other));
        stage.render();
        const nicol_statistics swapped = statistics_of(stage.framebuffer);
        CHECK(swapped.lights_projected == 0);
        CHECK(swapped.materials_projected > 0);
        CHECK(swapped.materials_projected == first.materials_projected);
        CHECK(swapped.vertices_traced == 0);
        CHECK(swapped.vertices_relit == 0);
        if (swapped.compute == 0) {
            CHECK(swapped.vertices_shaded > 0);
            CHECK(swapped.vertices_shaded <= first.vertices / 2);
        }
        CHECK(read_all(stage.framebuffer) == fresh(context, stage, stage.scene));
        OK(nicol_scene_set_material(stage.scene, id, other));
        stage.render();
        CHECK(statistics_of(stage.framebuffer).vertices_shaded == 0);
        CHECK(statistics_of(stage.framebuffer).draw_ms == 0);

        nicol_material unfit = diffuse(context, {0.1F, 0.2F});
        const std::vector<float> before = read_all(stage.framebuffer);
        FAILS(nicol_scene_set_material(stage.scene, id, unfit), NICOL_ERROR_INVALID_ARGUMENT, "channels");
        const Owned elsewhere(make_context(NICOL_BACKEND_OSMESA));
        const nicol_material foreign = grey(elsewhere, 0.2F);
        FAILS(nicol_scene_set_material(stage.scene, id, foreign), NICOL_ERROR_INVALID_HANDLE, "contexts");
        stage.render();
        CHECK(read_all(stage.framebuffer) == before);
        for (const nicol_material each : {other, unfit, foreign}) OK(nicol_material_release(each));
    });
}

TEST_CASE("scenes are edited from several threads") {
    on_every_backend([](nicol_context context) {
        const Stage stage(context);
        std::vector<std::thread> threads;
        std::array<std::uint32_t, 4> left{};
        for (std::size_t t = 0; t < left.size(); ++t) {
            threads.emplace_back([&stage, &left, t] {
                nicol_instance instance = NICOL_INSTANCE_INIT;
                instance.mesh = stage.mesh;
                instance.material = stage.material;
                for (int i = 0; i < 50; ++i) {
                    std::uint32_t id = 0;
                    if (nicol_scene_add_instance(stage.scene, &instance, &id) != NICOL_OK) return;
                    if (i < 49 && nicol_scene_remove_instance(stage.scene, id) != NICOL_OK) return;
                    left[t] = id;
                }
            });
        }
        for (std::thread& thread : threads) thread.join();
        std::set<std::uint32_t> expected(left.begin(), left.end());
        expected.insert(0);
        const std::vector<std::uint32_t> ids = ids_of(stage.scene);
        CHECK(std::set(ids.begin(), ids.end()) == expected);
        CHECK(ids.size() == 5);
        CHECK(ids.back() <= 200);
    });
}
