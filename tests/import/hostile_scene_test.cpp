// SPDX-License-Identifier: MIT
// Tests of scenes that are large enough to expose algorithms of quadratic time.
#include "import/load_scene.hpp"
#include "import/scene_file.hpp"
#include "material/material.hpp"

using namespace nicol;

namespace {

template <class Text>
std::string listed_texts(std::size_t count, const Text& text) {
    std::string out;
    for (std::size_t i = 0; i < count; ++i) out += text(i);
    return out;
}

std::string defaults(std::size_t count) {
    return listed_texts(
        count, [](std::size_t i) { return "<default name='a" + std::to_string(i) + "' value=''/>"; });
}

}  // namespace

TEST_CASE("many parameters are replaced in linear time, the longest name first") {
    const std::string uses = listed_texts(1000000, [](std::size_t) { return "$a1"; });
    CHECK(read(defaults(200000) + "<default name='far' value='x'/><default name='farther' value='y'/>" +
               a_sensor + "<shape type='obj'><string name='filename' value='" + uses +
               "$farther.ply $far.ply $a100 .obj'/></shape>")
              .shapes.at(0)
              .filename.filename() == "y.ply x.ply  .obj");
}

TEST_CASE("parameters that are not defined are reported in linear time") {
    // Undefined parameters of samplers are ignored.
    const std::string samplers =
        listed_texts(100000, [](std::size_t) { return "<sampler type='independent' x='$b'/>\n"; });
    CHECK(read(defaults(150000) + a_sensor + a_shape + samplers).notices.size() > 1);
    // The list of names in a message has a limited length.
    const std::string message =
        error_of(CALL(read(defaults(100000) + "<shape type='$b'/>")), ErrorCode::invalid_file);
    CHECK(message.find("undefined parameter") != std::string::npos);
    CHECK(message.size() < 1000);
}

TEST_CASE("replaced parameters do not fill the memory") {
    const std::string value(60000, 'x');
    const std::string uses = listed_texts(10000, [](std::size_t) { return "<string name='$a'/>"; });
    const SceneFile file(
        scene("<default name='a' value='" + value + "'/>" + a_sensor + "<film>" + uses + "</film>"));
    check_refused(file, ErrorCode::unsupported, file.scene().string() + ":3", {"16 MiB", "parameters"});
}

TEST_CASE("names of defaults are those that a scene can use") {
    for (const std::string& name : {std::string("a\\$b"), std::string(257, 'a')}) {
        const SceneFile file(scene("<default name='" + name + "' value=''/>"));
        check_refused(file, ErrorCode::invalid_file, file.scene().string() + ":2", {"<default>: the name"});
    }
}

TEST_CASE("many notices are kept in linear time") {
    const std::string sensors =
        listed_texts(400000, [](std::size_t) { return "<sensor type='orthographic'/>\n"; });
    CHECK(read(a_sensor + a_shape + sensors).notices.size() >= 400000);
}

TEST_CASE("many shapes and lights are added in linear time") {
    Scene all;
    const auto mesh = std::make_shared<const Mesh>(make_rectangle());
    const MaterialPtr material = diffuse({0.1, 0.2, 0.3});
    for (std::size_t i = 0; i < 1000000; ++i) {
        all.add_light({.kind = LocalLight::Kind::point, .value = {1, 1, 1}});
        all.add({.mesh = mesh, .material = material});
    }
    CHECK(all.channels() == 3);
    CHECK(all.ids().size() == 1000000);
}

TEST_CASE("the channels of a scene are those of the parts that it has at the time") {
    Scene parts;
    CHECK(parts.channels() == 1);
    const auto mesh = std::make_shared<const Mesh>(make_rectangle());
    const MaterialPtr grey = diffuse({0.5}), two = diffuse({0.5, 0.4}), three = diffuse({0.5, 0.4, 0.3});
    const std::uint32_t a = parts.add({.mesh = mesh, .material = three});
    const std::uint32_t b = parts.add({.mesh = mesh, .material = grey});
    CHECK(parts.channels() == 3);
    CHECK_INVALID(parts.set_material(b, two));
    parts.set_material(a, two);
    CHECK(parts.channels() == 2);
    parts.set_material(b, two);
    const std::uint32_t light = parts.add_light({.kind = LocalLight::Kind::point, .value = {1, 1}});
    CHECK_INVALID(parts.set_material(a, three));
    parts.remove(a);
    parts.remove(b);
    CHECK(parts.channels() == 2);
    parts.set_light(light, {.kind = LocalLight::Kind::point, .value = {1, 1, 1}});
    CHECK(parts.channels() == 3);
    parts.remove_light(light);
    CHECK(parts.channels() == 1);
    parts.set_environment(constant_environment({1, 1, 1, 1}), glm::dmat3(1.0), 1);
    CHECK(parts.channels() == 4);
    parts.set_environment(nullptr, glm::dmat3(1.0), 1);
    CHECK(parts.channels() == 1);
}
