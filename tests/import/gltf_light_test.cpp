// SPDX-License-Identifier: MIT
// Tests of lights in glTF files: KHR_lights_punctual.
#include "import/gltf_file.hpp"

using namespace nicol;

namespace {

/// Returns the JSON of a triangle, more nodes, and the lights.
std::string lit(const std::string& nodes, const std::string& lights) {
    return one_mesh() + ",\"nodes\":[{\"mesh\":0}," + nodes +
           "],\"extensions\":{\"KHR_lights_punctual\":{\"lights\":[" + lights + "]}}";
}

std::string node(const std::string& light, const std::string& more = "") {
    return "{\"extensions\":{\"KHR_lights_punctual\":{\"light\":" + light + "}}" + more + "}";
}

LoadedScene load(const std::string& rest) {
    return load_scene(GltfFile(triangle_buffer(), rest).scene(), {});
}

}  // namespace

TEST_CASE("lights of glTF: their numbers as they are, along the node's -z") {
    // A rotation of 90 degrees about y maps -z to -x. Scales have no effect.
    const std::string at =
        ",\"translation\":[1,2,3],\"scale\":[2,3,4],\"rotation\":[0,0.70710678,0,0.70710678]";
    const LoadedScene loaded = load(lit(
        node("0", at) + "," + node("1", at + ",\"name\":\"lamp\"") + "," + node("2", at) + "," + node("1"),
        "{\"type\":\"directional\",\"intensity\":3,\"color\":[1,0.5,0]},{\"type\":\"point\"},"
        "{\"type\":\"spot\",\"intensity\":2,\"spot\":{\"innerConeAngle\":0.2,\"outerConeAngle\":0.5}}"));
    const std::vector<LocalLight>& lights = loaded.scene.lights();
    REQUIRE(lights.size() == 4);
    CHECK(loaded.notices.empty());
    CHECK(lights[0].kind == LocalLight::Kind::directional);
    CHECK(lights[0].value == std::vector<double>{3, 1.5, 0});
    CHECK(lights[1].kind == LocalLight::Kind::point);
    CHECK(lights[1].value == std::vector<double>{1, 1, 1});
    CHECK(lights[2].kind == LocalLight::Kind::spot);
    CHECK(lights[2].value == std::vector<double>{2, 2, 2});
    CHECK(lights[2].beam_width == 0.2);
    CHECK(lights[2].cutoff_angle == 0.5);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(glm::distance(glm::dvec3(lights[i].to_world[2]), glm::dvec3(-1, 0, 0)) < 1e-6);
        CHECK(glm::distance(glm::dvec3(lights[i].to_world[1]), glm::dvec3(0, 1, 0)) < 1e-6);
        CHECK(glm::dvec3(lights[i].to_world[3]) == glm::dvec3(1, 2, 3));
    }
    CHECK(glm::dvec3(lights[3].to_world[2]) == glm::dvec3(0, 0, -1));
}

TEST_CASE("a spot of glTF without angles is 45 degrees wide") {
    const LoadedScene loaded = load(lit(node("0"), "{\"type\":\"spot\",\"spot\":{}}"));
    CHECK(loaded.scene.lights().at(0).beam_width == 0);
    CHECK(loaded.scene.lights().at(0).cutoff_angle == doctest::Approx(pi / 4));
}

TEST_CASE("the range of lights is one notice, and lights of no node have no effect") {
    const LoadedScene loaded = load(lit(node("0") + "," + node("1"),
                                        "{\"type\":\"point\",\"range\":5},{\"type\":\"point\",\"range\":6},"
                                        "{\"type\":\"point\"}"));
    CHECK(loaded.scene.lights().size() == 2);
    REQUIRE(loaded.notices.size() == 1);
    CHECK(loaded.notices[0].find("the range of lights is not followed") != std::string::npos);
}

TEST_CASE("lights of glTF that cannot be are refused by element") {
    struct Case {
        std::string nodes, lights, part;
    };
    const auto spot = [](const std::string& angles) {
        return "{\"type\":\"spot\",\"spot\":{" + angles + "}}";
    };
    const std::string point = "{\"type\":\"point\"}";
    for (const Case& c : {
             Case{node("1"), point, "nodes[1]: refers to lights[1]; the file has 1"},
             Case{node("-1"), point, "nodes[1]: refers to lights[-1]"},
             Case{node("\"a\""), point, "nodes[1]: KHR_lights_punctual has no light"},
             Case{"{\"extensions\":{\"KHR_lights_punctual\":{}}}", point,
                  "nodes[1]: KHR_lights_punctual has no light"},
             Case{node("0"), "{\"type\":\"area\"}", "lights[0]: type is \"area\""},
             Case{node("0"), "{\"type\":\"point\",\"intensity\":-1}", "lights[0]: intensity is -1"},
             Case{node("0"), "{\"type\":\"point\",\"color\":[1,2]}", "lights[0]: color has 2 numbers"},
             Case{node("0"), "{\"type\":\"point\",\"color\":[1,-2,0]}", "lights[0]: color is -2"},
             Case{node("0"), spot("\"outerConeAngle\":0"), "lights[0].spot: outerConeAngle is 0"},
             Case{node("0"), spot("\"outerConeAngle\":1.6"), "lights[0].spot: outerConeAngle is 1.6"},
             Case{node("0"), spot("\"innerConeAngle\":0.8"), "lights[0].spot: innerConeAngle is 0.8"},
             Case{node("0"), spot("\"innerConeAngle\":-0.1"), "lights[0].spot: innerConeAngle is -0.1"},
             Case{node("0", ",\"scale\":[1,1,0]"), point, "nodes[1]: its light has axes of no length"},
         }) {
        const GltfFile file(triangle_buffer(), lit(c.nodes, c.lights));
        const std::string message = error_of(CALL(read_gltf_scene(file.scene())), ErrorCode::invalid_file);
        CAPTURE(message);
        CHECK(message.find("a.gltf: " + c.part) != std::string::npos);
    }
}
