// SPDX-License-Identifier: MIT
// Tests of glTF files at a time: animations, morph targets and skins.
#include "geometry/deformed_mesh.hpp"
#include "import/gltf_file.hpp"

using namespace nicol;

namespace {

/// The members of an animation with one channel: `path` of node 0 by `sampler`.
std::string animation_of(const std::string& path, const std::string& sampler) {
    return ",\"animations\":[{\"name\":\"walk\",\"channels\":[{\"sampler\":0,\"target\":{\"node\":0,\"path\":"
           "\"" +
           path + "\"}}],\"samplers\":[{" + sampler + "}]}]";
}

SceneParameters at_time(double time) {
    return {{"time", std::to_string(time)}};
}

/// A triangle whose node has a channel of values at the times 1 s and 3 s.
struct Track {
    Track(const std::string& path, const std::string& interpolation, const std::string& shape,
          const std::vector<float>& values, std::size_t count)
        : file(buffer_of(shape, values, count),
               one_mesh() + ",\"nodes\":[{\"mesh\":0,\"translation\":[0,0,9]}]" +
                   animation_of(path,
                                "\"input\":1,\"output\":2,\"interpolation\":\"" + interpolation + "\"")) {}

    [[nodiscard]] glm::dmat4 place(double time) const {
        return read_gltf_scene(file.scene(), at_time(time)).shapes.at(0).to_world;
    }

    static GltfBuffer buffer_of(const std::string& shape, const std::vector<float>& values,
                                std::size_t count) {
        GltfBuffer buffer = triangle_buffer();
        buffer.accessor("SCALAR", gltf_float, 2, GltfBuffer::of(buffer.view(std::vector<float>{1, 3})));
        buffer.accessor(shape, gltf_float, count, GltfBuffer::of(buffer.view(values)));
        return buffer;
    }

    GltfFile file;
};

void check_near(const glm::dvec3& a, const glm::dvec3& b) {
    CHECK(glm::distance(a, b) < 1e-6);
}

}  // namespace

TEST_CASE("channels of glTF move nodes, and hold their first and last values") {
    const Track linear("translation", "LINEAR", "VEC3", {0, 0, 0, 4, 2, 0}, 2);
    check_near(linear.place(0)[3], {0, 0, 0});
    check_near(linear.place(1.5)[3], {1, 0.5, 0});
    check_near(linear.place(3)[3], {4, 2, 0});
    check_near(linear.place(7)[3], {4, 2, 0});
    // Without a time the node has its own place.
    check_near(read_gltf_scene(linear.file.scene()).shapes.at(0).to_world[3], {0, 0, 9});
    CHECK(has_notice(read_gltf_scene(linear.file.scene()), "animations are followed only with a time"));
    CHECK(read_gltf_scene(linear.file.scene(), at_time(1)).notices.empty());

    const Track step("scale", "STEP", "VEC3", {1, 1, 1, 2, 3, 4}, 2);
    CHECK(step.place(2.999)[1][1] == doctest::Approx(1));
    CHECK(step.place(3)[1][1] == doctest::Approx(3));
    check_near(step.place(2)[3], {0, 0, 9});

    // Hermite's spline with tangents 1 per second from 0 to 2 in 2 s is a line.
    const Track cubic("translation", "CUBICSPLINE", "VEC3",
                      {0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 2, 0, 0, 0, 0, 0}, 6);
    check_near(cubic.place(1.5)[3], {0.5, 0, 0});
    check_near(cubic.place(2)[3], {1, 0, 0});
    check_near(cubic.place(3)[3], {2, 0, 0});

    // Quaternions of either sign are the same rotation, and the way between them is the shorter one.
    const float half = std::sqrt(0.5F);
    const Track rotation("rotation", "LINEAR", "VEC4", {0, 0, 0, 1, 0, 0, -half, -half}, 2);
    const glm::dmat4 turned = rotation.place(2);
    check_near(turned * glm::dvec4(1, 0, 0, 0), {std::cos(pi / 4), std::sin(pi / 4), 0});
}

TEST_CASE("morph targets of glTF shift vertices by the weights of animation, node or mesh") {
    GltfBuffer buffer = triangle_buffer();
    const int first = buffer.vectors({{0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
    const int second = buffer.vectors({{0, 0, 0}, {2, 0, 0}, {0, 0, 0}});
    const int times =
        buffer.accessor("SCALAR", gltf_float, 2, GltfBuffer::of(buffer.view(std::vector<float>{0, 1})));
    const int weights = buffer.accessor("SCALAR", gltf_float, 4,
                                        GltfBuffer::of(buffer.view(std::vector<float>{0, 0, 1, 0.5F})));
    const std::string mesh =
        "\"meshes\":[{\"weights\":[0.5,0],\"primitives\":[{\"attributes\":{\"POSITION\":0},"
        "\"targets\":[{\"POSITION\":" +
        std::to_string(first) + "},{\"POSITION\":" + std::to_string(second) + "}]}]}]";
    const GltfFile file(buffer, mesh + ",\"nodes\":[{\"mesh\":0},{\"mesh\":0,\"weights\":[0,1]}]" +
                                    animation_of("weights", "\"input\":" + std::to_string(times) +
                                                                ",\"output\":" + std::to_string(weights)));
    const SceneDescription rest = read_gltf_scene(file.scene());
    CHECK(rest.shapes.at(0).mesh->positions[0].z == doctest::Approx(0.5));
    CHECK(rest.shapes.at(1).mesh->positions[0].z == doctest::Approx(0));
    CHECK(rest.shapes.at(1).mesh->positions[1].x == doctest::Approx(3));
    const SceneDescription later = read_gltf_scene(file.scene(), at_time(0.5));
    CHECK(later.shapes.at(0).mesh->positions[1].z == doctest::Approx(0.5));
    CHECK(later.shapes.at(0).mesh->positions[1].x == doctest::Approx(1.5));
    CHECK(later.shapes.at(1).mesh->positions == rest.shapes.at(1).mesh->positions);
    CHECK(same_triangles(*later.shapes.at(0).mesh, *rest.shapes.at(0).mesh));
}

namespace {

/// A triangle with normals that follows two joints, nodes 1 and 2, the second bound one unit to the right.
std::string skinned(GltfBuffer& buffer, const std::vector<std::uint8_t>& joints) {
    const int normals = buffer.vectors(std::vector<glm::vec3>(3, {0, 0, 2}));
    const int of = buffer.accessor("VEC4", gltf_ubyte, 3, GltfBuffer::of(buffer.view(joints)));
    const int weights = buffer.accessor(
        "VEC4", gltf_float, 3,
        GltfBuffer::of(buffer.view(std::vector<float>{1, 0, 0, 0, 0, 2, 0, 0, 0.25F, 0.25F, 0, 0})));
    const std::vector<float> binds = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1,
                                      1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1};
    const int inverse = buffer.accessor("MAT4", gltf_float, 2, GltfBuffer::of(buffer.view(binds)));
    return "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"NORMAL\":" +
           std::to_string(normals) + ",\"JOINTS_0\":" + std::to_string(of) +
           ",\"WEIGHTS_0\":" + std::to_string(weights) +
           "}}]}],\"skins\":[{\"joints\":[1,2],\"inverseBindMatrices\":" + std::to_string(inverse) + "}]";
}

const std::vector<std::uint8_t> both_joints = {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0};

}  // namespace

TEST_CASE("vertices of a glTF skin follow their joints, not their node") {
    GltfBuffer buffer = triangle_buffer();
    const std::string mesh = skinned(buffer, both_joints);
    // Joint 1 is at (0, 0, 3); joint 2 at (5, 0, 0), a quarter turn about z.
    const GltfFile file(
        buffer, mesh +
                    ",\"nodes\":[{\"mesh\":0,\"skin\":0,\"translation\":[7,7,7]},{\"translation\":[0,0,3]},"
                    "{\"translation\":[5,0,0],\"rotation\":[0,0,0.70710678,0.70710678]}]");
    const SceneDescription scene = read_gltf_scene(file.scene());
    REQUIRE(scene.shapes.size() == 1);
    CHECK(scene.notices.empty());
    CHECK(scene.shapes[0].to_world == glm::dmat4(1));
    const Mesh& posed = *scene.shapes[0].mesh;
    check_near(posed.positions[0], {0, 0, 3});
    check_near(posed.positions[1], {5, 0, 0});
    // Half of (0, 1, 3) and half of what the quarter turn makes of (-1, 1, 0).
    check_near(posed.positions[2], {0.5 * (0 + 5 - 1), 0.5 * (1 - 1), 1.5});
    check_near(posed.normals[0], {0, 0, 1});
    CHECK(glm::length(posed.normals[2]) == doctest::Approx(1));
}

TEST_CASE("glTF that animates or deforms wrongly is refused by element") {
    const Track track("translation", "LINEAR", "VEC3", {0, 0, 0, 4, 2, 0}, 2);
    const auto refusal = [&](const SceneParameters& parameters) {
        return error_of(CALL(read_gltf_scene(track.file.scene(), parameters)));
    };
    CHECK(refusal({{"time", "soon"}}).find("the parameter time is \"soon\"") != std::string::npos);
    CHECK(refusal({{"animation", "0"}}).find("needs a time") != std::string::npos);
    CHECK(refusal({{"speed", "1"}}).find("those of glTF files are time and animation") != std::string::npos);
    CHECK(refusal({{"time", "1"}, {"animation", "run"}}).find("there is no animation \"run\"") !=
          std::string::npos);
    CHECK_NOTHROW(
        static_cast<void>(read_gltf_scene(track.file.scene(), {{"time", "1"}, {"animation", "walk"}})));
    const GltfFile still(triangle_buffer(), one_mesh() + ",\"nodes\":[{\"mesh\":0}]");
    CHECK(error_of(CALL(read_gltf_scene(still.scene(), at_time(0)))).find("has no animations") !=
          std::string::npos);

    const auto wrong = [](const std::string& path, const std::string& interpolation, const std::string& shape,
                          const std::vector<float>& values, std::size_t count) {
        const Track made(path, interpolation, shape, values, count);
        return error_of(CALL(made.place(2)), ErrorCode::invalid_file);
    };
    CHECK(wrong("translation", "LINEAR", "VEC3", {0, 0, 0}, 1).find("expected 3 per key") !=
          std::string::npos);
    CHECK(wrong("translation", "CUBICSPLINE", "VEC3", {0, 0, 0, 1, 1, 1}, 2).find("expected 9 per key") !=
          std::string::npos);
    CHECK(wrong("scale", "NEAREST", "VEC3", {1, 1, 1, 1, 1, 1}, 2).find("interpolation is \"NEAREST\"") !=
          std::string::npos);
    CHECK(wrong("rotation", "LINEAR", "VEC4", std::vector<float>(8, 0), 2).find("rotation of length 0") !=
          std::string::npos);
    CHECK(wrong("translation", "LINEAR", "VEC3", {NAN, 0, 0, 0, 0, 0}, 2).find("not finite") !=
          std::string::npos);

    GltfBuffer buffer = triangle_buffer();
    std::vector<std::uint8_t> joints = both_joints;
    joints[5] = 2;
    const std::string mesh = skinned(buffer, joints);
    const GltfFile beyond(buffer, mesh + ",\"nodes\":[{\"mesh\":0,\"skin\":0},{},{}]");
    CHECK(error_of(CALL(read_gltf_scene(beyond.scene())), ErrorCode::invalid_file)
              .find("vertex 1 follows joint 2, but its skin has only 2") != std::string::npos);
}
