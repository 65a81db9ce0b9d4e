// SPDX-License-Identifier: MIT
// Tests of loaded scenes that go to other times, against files that are loaded at these times.
#include "import/scene_animation.hpp"

#include "import/gltf_file.hpp"

using namespace nicol;

namespace {

/// A triangle that moves and vanishes from 2 s to 3 s, and one that a morph target shifts.
GltfFile moving_file() {
    GltfBuffer buffer = triangle_buffer();
    buffer.vectors({{0, 0, 1}, {0, 0, 1}, {0, 0, 2}});
    const auto numbers = [&buffer](const std::string& shape, std::size_t count,
                                   const std::vector<float>& values) {
        buffer.accessor(shape, gltf_float, count, GltfBuffer::of(buffer.view(values)));
    };
    numbers("SCALAR", 3, {0, 2, 3});
    numbers("VEC3", 3, {0, 0, 0, 1, 2, 3, 4, 5, 6});
    numbers("VEC3", 3, {1, 1, 1, 0, 0, 0, 2, 2, 2});
    numbers("SCALAR", 3, {0, 1, 0.5F});
    return {
        buffer,
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]},{\"primitives\":[{\"attributes\":{"
        "\"POSITION\":0},\"targets\":[{\"POSITION\":1}]}]}],\"nodes\":[{\"mesh\":0},{\"mesh\":1}],"
        "\"animations\":[{\"channels\":["
        "{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"translation\"}},"
        "{\"sampler\":1,\"target\":{\"node\":0,\"path\":\"scale\"}},"
        "{\"sampler\":2,\"target\":{\"node\":1,\"path\":\"weights\"}}],\"samplers\":["
        "{\"input\":2,\"output\":3},{\"input\":2,\"output\":4,\"interpolation\":\"STEP\"},"
        "{\"input\":2,\"output\":5}]}]"};
}

void check_equal(const LoadedScene& found, const LoadedScene& expected) {
    std::vector<Instance> a = found.scene.instances(), b = expected.scene.instances();
    REQUIRE(a.size() == b.size());
    // An instance that came back has another number.
    const auto by_place = [](const Instance& i) { return i.to_world[3].x; };
    std::ranges::sort(a, {}, by_place);
    std::ranges::sort(b, {}, by_place);
    for (std::size_t i = 0; i < a.size(); ++i) {
        CHECK(a[i].to_world == b[i].to_world);
        CHECK(a[i].mesh->positions == b[i].mesh->positions);
        CHECK(a[i].mesh->normals == b[i].mesh->normals);
    }
    CHECK(found.camera == expected.camera);
}

}  // namespace

TEST_CASE("a scene at a time is that of a file loaded at this time") {
    const GltfFile file = moving_file();
    LoadedScene moving = load_scene(file.scene(), {});
    REQUIRE(moving.animation);
    for (const char* const time : {"0.5", "1.5", "2.5", "3", "2", "0"}) {
        CAPTURE(time);
        moving.animation->set_time(std::stod(time), {}, moving.scene, moving.camera);
        const LoadedScene loaded = load_scene(file.scene(), {{"time", time}});
        check_equal(moving, loaded);
        CHECK(loaded.scene.instances().size() == (std::string_view(time).starts_with("2") ? 1 : 2));
    }
    LoadedScene later = load_scene(file.scene(), {{"time", "2.5"}});
    later.animation->set_time(1, {}, later.scene, later.camera);
    check_equal(later, load_scene(file.scene(), {{"time", "1"}}));
}

TEST_CASE("a mesh that its deformation makes flat when it is loaded is drawn at other times") {
    GltfBuffer buffer = triangle_buffer();
    std::vector<glm::vec3> to_origin;
    for (const glm::vec3& corner : a_gltf_triangle) to_origin.push_back(-corner);
    buffer.vectors(to_origin);
    for (const std::vector<float>& values : {std::vector<float>{0, 1}, {1, 0}})
        buffer.accessor("SCALAR", gltf_float, 2, GltfBuffer::of(buffer.view(values)));
    const GltfFile file(
        buffer,
        "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"targets\":[{\"POSITION\":1}]}]}],"
        "\"nodes\":[{\"mesh\":0}],\"animations\":[{\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,"
        "\"path\":\"weights\"}}],\"samplers\":[{\"input\":2,\"output\":3}]}]");
    LoadedScene moving = load_scene(file.scene(), {{"time", "0"}});
    CHECK(moving.scene.instances().empty());
    CHECK(moving.camera.near_clip > 0);
    moving.animation->set_time(1, {}, moving.scene, moving.camera);
    check_equal(moving, load_scene(file.scene(), {{"time", "1"}}));
    moving.animation->set_time(0, {}, moving.scene, moving.camera);
    CHECK(moving.scene.instances().empty());
}

TEST_CASE("what does not deform keeps its mesh, and a scene that rests changes nothing") {
    const GltfFile file = moving_file();
    LoadedScene moving = load_scene(file.scene(), {{"time", "0"}});
    const std::shared_ptr<const Mesh> mesh = moving.scene.at(0).mesh;
    moving.animation->set_time(1, {}, moving.scene, moving.camera);
    CHECK(moving.scene.at(0).mesh == mesh);
    CHECK_THROWS_AS(moving.animation->set_time(std::nan(""), {}, moving.scene, moving.camera), Error);
    moving.scene.set_mesh(0, std::make_shared<const Mesh>(*mesh));
    moving.animation->set_time(1, {}, moving.scene, moving.camera);
    CHECK(moving.scene.at(0).mesh == mesh);
    const GltfFile still(triangle_buffer(), one_mesh() + ",\"nodes\":[{\"mesh\":0}]");
    CHECK_FALSE(load_scene(still.scene(), {}).animation);
}
