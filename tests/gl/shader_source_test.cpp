// SPDX-License-Identifier: MIT
// Tests of shader text: includes, definitions and message translation.
#include "gl/shader_source.hpp"

#include "gl/test_shaders.hpp"
#include "test.hpp"

using namespace nicol;
using namespace nicol::gl;

namespace {

std::size_t occurrences(std::string_view text, std::string_view part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

}  // namespace

TEST_CASE("the shaders of the library are found by name") {
    CHECK(embedded_shader("fullscreen.vert").text.find("gl_VertexID") != std::string_view::npos);
    const std::string text = error_of(CALL(embedded_shader("nothing.frag")));
    CHECK(text.find("nothing.frag") != std::string::npos);
    CHECK(text.find("fullscreen.vert") != std::string::npos);
}

TEST_CASE("an include is taken once and is no stage of its own") {
    const ShaderSource shader = test_shader("uniforms.comp");
    CHECK(occurrences(shader.text, "float nested_value()") == 1);
    CHECK(occurrences(shader.text, "#include") == 0);
    CHECK_THROWS(static_cast<void>(test_shader("nested.glsl")));
}

TEST_CASE("definitions stand behind the version") {
    const std::array<Define, 2> defines{{{"ORDER", "4"}, {"FLAG"}}};
    const ShaderSource plain{"plain.comp", "// a comment\n#version 450 core\nvoid main() {}\n"};
    CHECK(with_defines(plain, defines) ==
          "// a comment\n#version 450 core\n#define ORDER 4\n#define FLAG 1\n#line 3 0\nvoid main() {}\n");
    CHECK(with_defines(plain, {}) == plain.text);
    const ShaderSource bare{"bare.comp", "#version 450 core"};
    CHECK(with_defines(bare, {}) == "#version 450 core\n");
}

TEST_CASE("definitions that are no definitions are refused") {
    const ShaderSource plain{"plain.comp", "#version 450 core\nvoid main() {}\n"};
    for (const char* name : {"", "4D", "A B", "GL_ES", "A__B", "A(x)", "A\n#error"}) {
        CAPTURE(name);
        const Define define{name, "1"};
        CHECK_THROWS_AS(static_cast<void>(with_defines(plain, {&define, 1})), Error);
    }
    for (const char* value : {"1\n#error", "1\\", "1\r"}) {
        const Define define{"A", value};
        CHECK_THROWS_AS(static_cast<void>(with_defines(plain, {&define, 1})), Error);
    }
    const ShaderSource without{"without.comp", "void main() {}\n"};
    CHECK_THROWS_AS(static_cast<void>(with_defines(without, {})), Error);
}

TEST_CASE("messages of every driver's form get file names") {
    const ShaderSource shader{"a.frag", "//@ 0 a.frag\n//@ 1 b.glsl\n#version 450 core\n"};
    CHECK(with_file_names(shader, "0:12(5): error: x") == "a.frag:12: error: x\n");
    CHECK(with_file_names(shader, "1(7) : error C1008: y") == "b.glsl:7: error C1008: y\n");
    CHECK(with_file_names(shader, "ERROR: 1:3: 'z' : undeclared\n0:1(1): warning: w\n") ==
          "ERROR: b.glsl:3: 'z' : undeclared\na.frag:1: warning: w\n");
    CHECK(with_file_names(shader, "2:1(1): error: no such source") == "2:1(1): error: no such source\n");
    CHECK(with_file_names(shader, "99999999999999999999:1(1): error") ==
          "99999999999999999999:1(1): error\n");
    CHECK(with_file_names(shader, "no place at all") == "no place at all\n");
    CHECK(with_file_names({"c.vert", "#version 450 core\n"}, "0:2(1): error: v") == "c.vert:2: error: v\n");
}
