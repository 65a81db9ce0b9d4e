// SPDX-License-Identifier: MIT
// Tests of edits to scenes: removing and querying instances, and changing their materials.
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

// Renders a new scene made of the same instances.
std::vector<float> fresh(const Stage& stage) {
    const Owned scene(empty_scene(stage.context));
    OK(nicol_scene_set_environment(scene, stage.environment, nullptr, 1));
    for (const std::uint32_t id : ids_of(stage.scene)) {
        Owned<nicol_mesh> mesh;
        Owned<nicol_material> material;
        Matrix at{};
        OK(nicol_scene_get_instance(stage.scene, id, &mesh, &material, at.rows));
        add(scene, mesh, material, at);
    }
    const Owned framebuffer(framebuffer_of(stage.context, 24, 16, 3));
    const nicol_render_options options = plain_options();
    OK(nicol_render(scene, &stage.camera, &options, framebuffer));
    return read_all(framebuffer);
}

}  // namespace

STAGE_TEST_CASE("ids of removed instances are not given again, and those of others stay") {
    const std::uint32_t second = add(stage.scene, stage.mesh, stage.material, placed(1, 0, 0, 0.3));
    const std::uint32_t third = add(stage.scene, stage.mesh, stage.material, placed(-1, 0, 0, 0.3));
    CHECK(ids_of(stage.scene) == std::vector<std::uint32_t>{0, 1, 2});
    OK(nicol_scene_remove_instance(stage.scene, second));
    CHECK(ids_of(stage.scene) == std::vector<std::uint32_t>{0, 2});
    CHECK(stage.image() == fresh(stage));

    REFUSES(nicol_scene_remove_instance(stage.scene, second), "instance 1");
    REFUSES(nicol_scene_set_transform(stage.scene, second, placed(0, 0, 0).rows), "removed");
    REFUSES(nicol_scene_set_material(stage.scene, second, stage.material), "instance 1");
    REFUSES(nicol_scene_remove_instance(stage.scene, 3), "instance 3");
    for (const std::uint32_t id : {0U, third}) OK(nicol_scene_remove_instance(stage.scene, id));
    CHECK(ids_of(stage.scene).empty());
    OK(nicol_scene_get_instance_ids(stage.scene, nullptr, 0));
    CHECK(stage.image() == fresh(stage));
}

STAGE_TEST_CASE("an instance tells what it is made of") {
    const Matrix at = placed(1, 2, 3, 0.5);
    const std::uint32_t id =
        add(stage.scene, stage.mesh, Owned(diffuse(stage.context, {0.3F})), at);  // kept by the scene
    Owned<nicol_mesh> mesh;
    Owned<nicol_material> material;
    Matrix told{};
    OK(nicol_scene_get_instance(stage.scene, id, &mesh, &material, told.rows));
    CHECK(std::ranges::equal(at.rows, told.rows));
    std::array<std::uint32_t, 2> size{}, wanted{};
    OK(nicol_mesh_get_size(mesh, size.data(), size.data() + 1));
    OK(nicol_mesh_get_size(stage.mesh, wanted.data(), wanted.data() + 1));
    CHECK(size == wanted);
    OK(nicol_scene_remove_instance(stage.scene, id));
    // The mesh and the material live as long as their handles.
    CHECK(add(stage.scene, mesh, material, at) == id + 1);
    OK(nicol_scene_get_instance(stage.scene, id + 1, nullptr, nullptr, nullptr));

    nicol_mesh no_mesh = marker<nicol_mesh>();
    nicol_material no_material = marker<nicol_material>();
    REFUSES(nicol_scene_get_instance(stage.scene, id, &no_mesh, &no_material, told.rows), "removed");
    CHECK(no_mesh == marker<nicol_mesh>());
    CHECK(no_material == marker<nicol_material>());
    CHECK(std::ranges::equal(at.rows, told.rows));
}

STAGE_TEST_CASE("a material is swapped for one that fits the others' channels") {
    const std::uint32_t id = add(stage.scene, stage.mesh, stage.material, placed(0.6, 0.5, 0.5, 0.3));
    stage.render();
    OK(nicol_scene_set_material(stage.scene, id, Owned(diffuse(stage.context, {0.2F}))));
    const std::vector<float> image = stage.image();
    CHECK(statistics_of(stage.framebuffer).vertices_relit == 0);
    CHECK(image == fresh(stage));

    const Owned elsewhere(make_context(NICOL_BACKEND_OSMESA));
    const Owned foreign(diffuse(elsewhere, {0.2F})), unfit(diffuse(stage.context, {0.1F, 0.2F}));
    REFUSES(nicol_scene_set_material(stage.scene, id, unfit), "channels");
    FAILS(nicol_scene_set_material(stage.scene, id, foreign), NICOL_ERROR_INVALID_HANDLE, "contexts");
    CHECK(stage.image() == image);
}

STAGE_TEST_CASE("an instance deforms, and has another mesh") {
    const std::uint32_t id = add(stage.scene, stage.mesh, stage.material, placed(0.6, 0.5, 0.5, 0.3));
    stage.render();
    std::uint32_t vertices = 0, triangles = 0;
    OK(nicol_mesh_get_size(stage.mesh, &vertices, &triangles));
    std::vector<float> positions;
    for (std::uint32_t v = 0; v < vertices; ++v) {
        const float angle = 0.1F * static_cast<float>(v);
        positions.insert(positions.end(), {std::cos(angle), std::sin(angle), 0.01F * static_cast<float>(v)});
    }
    nicol_deformation deformation = NICOL_DEFORMATION_INIT;
    deformation.vertex_count = vertices;
    deformation.positions = positions.data();
    const Owned bent(make(nicol_mesh_create_deformed, stage.context, stage.mesh, &deformation));
    std::uint32_t same_triangles = 0;
    OK(nicol_mesh_get_size(bent, &vertices, &same_triangles));
    CHECK(same_triangles == triangles);
    OK(nicol_scene_set_mesh(stage.scene, id, bent));
    CHECK(stage.image() == fresh(stage));
    OK(nicol_scene_set_mesh(stage.scene, id, Owned(cube(stage.context))));  // kept by the scene
    const std::vector<float> image = stage.image();
    CHECK(image == fresh(stage));

    nicol_mesh none = marker<nicol_mesh>();
    const auto refused = [&](const std::string& message) {
        REFUSES(nicol_mesh_create_deformed(stage.context, stage.mesh, &deformation, &none), message);
    };
    positions[4] = NAN;
    refused("the position of vertex 1 (0-based) is not finite");
    deformation.vertex_count = vertices + 1;
    refused("it must be that of the base, " + std::to_string(vertices));
    deformation.vertex_count = vertices;
    deformation.positions = nullptr;
    refused("deformation->positions is NULL");
    CHECK(none == marker<nicol_mesh>());
    REFUSES(nicol_scene_set_mesh(stage.scene, id + 1, bent), "there is no instance");
    const Owned elsewhere(make_context(NICOL_BACKEND_OSMESA));
    FAILS(nicol_scene_set_mesh(stage.scene, id, Owned(cube(elsewhere))), NICOL_ERROR_INVALID_HANDLE,
          "contexts");
    CHECK(stage.image() == image);
}

STAGE_TEST_CASE("scenes are edited from several threads") {
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
}
