// SPDX-License-Identifier: MIT
// Tests of compiling, definitions, messages and uniforms.
#include <glm/gtc/type_ptr.hpp>

#include "gl/buffer.hpp"
#include "gl/contexts.hpp"
#include "gl/draw.hpp"
#include "gl/test_shaders.hpp"

using namespace nicol;
using namespace nicol::gl;

GL_THREAD_TEST_CASE("definitions reach the shader and line numbers stay those of the file") {
    const std::array<Define, 2> defines{{{"WIDE", "3.5"}, {"HIGH", "(-1.0 / 4.0)"}}};
    const Program program =
        Program::graphics(context, embedded_shader("fullscreen.vert"), test_shader("lines.frag"), defines);
    RenderTarget target(context, {1, 1, 1, false});
    draw_fullscreen(target, program);
    std::array<float, 4> pixel{};
    target.read(0, pixel);
    CHECK(pixel == std::array{6.0f, 42.0f, 3.5f, -0.25f});
}

GL_THREAD_TEST_CASE("a compile error names the original file and line") {
    for (const bool with_define : {false, true}) {
        const Define define{"ANY", "1"};
        const std::span<const Define> defines(&define, with_define ? 1 : 0);
        check_error(ErrorCode::opengl,
                    CALL(Program::graphics(context, embedded_shader("fullscreen.vert"),
                                           test_shader("broken.frag"), defines)),
                    "the shader broken.frag does not compile", "nested_bad.glsl:3:", "undeclared_in_nested",
                    "broken.frag:7:", "undeclared_in_main");
    }
    // The context still works.
    const std::array<Define, 2> defines{{{"WIDE", "0.0"}, {"HIGH", "0.0"}}};
    CHECK_NOTHROW(
        Program::graphics(context, embedded_shader("fullscreen.vert"), test_shader("lines.frag"), defines));
    CHECK(total_bytes(context->memory()) == 0);
}

GL_THREAD_TEST_CASE("a link error names the program") {
    const ShaderSource vertex{"mismatch.vert",
                              "#version 450 core\nlayout(location = 0) out vec3 uv;\n"
                              "void main() { uv = vec3(1); gl_Position = vec4(uv, 1); }\n"};
    const Define scale{"SCALE", "1.0"};
    check_error(ErrorCode::opengl,
                CALL(Program::graphics(context, vertex, test_shader("gather.frag"), {&scale, 1})),
                "mismatch.vert + gather.frag does not link");
}

GL_THREAD_TEST_CASE("uniforms of every type arrive") {
    Program program = Program::compute(context, test_shader("uniforms.comp"));
    glm::mat3 m3;
    glm::mat4 m4;
    std::iota(glm::value_ptr(m3), glm::value_ptr(m3) + 9, 10.0f);
    std::iota(glm::value_ptr(m4), glm::value_ptr(m4) + 16, 20.0f);
    program.set("an_int", -3);
    program.set("an_unsigned", 4u);
    program.set("a_bool", 1);
    program.set("a_float", 0.5f);
    program.set("a_vec2", glm::vec2(1, 2));
    program.set("a_vec3", glm::vec3(3, 4, 5));
    program.set("a_vec4", glm::vec4(6, 7, 8, 9));
    program.set("a_mat3", m3);
    program.set("a_mat4", m4);
    program.set("an_array[0]", 36.0f);
    program.set("an_array[1]", 37.0f);
    std::vector<float> expected{-3, 4, 1, 0.5f, 1, 2, 3, 4, 5, 6, 7, 8, 9};
    for (const float first : {10.0f, 20.0f})
        for (int i = 0; i < (first < 20 ? 9 : 16); ++i) expected.push_back(first + static_cast<float>(i));
    expected.insert(expected.end(), {36, 37, 42});  // the array, and the value of the included file
    const Buffer output(context, BufferUse::storage, expected.size() * sizeof(float), BufferUpdate::fixed);
    output.bind_storage(0);
    dispatch(program, 1);
    std::vector<float> result(expected.size());
    output.read(0, std::as_writable_bytes(std::span(result)));
    CHECK(result == expected);

    // A value that changes back is another one each time.
    for (const float value : {0.25F, 0.5F, 0.5F}) {
        program.set("a_float", value);
        dispatch(program, 1);
        output.read(0, std::as_writable_bytes(std::span(result)));
        CHECK(result[3] == value);
    }
}

GL_THREAD_TEST_CASE("a uniform of another name or type is an error that says what there is") {
    Program program = Program::compute(context, test_shader("uniforms.comp"));
    CHECK(program.uses("a_float"));
    CHECK(!program.uses("a_flaot"));
    const auto bad = ErrorCode::invalid_argument;
    check_error(bad, CALL(program.set("a_flaot", 1.0f)), "a_flaot", "uniforms.comp", "a_float");
    check_error(bad, CALL(program.set("a_vec3", 1.0f)), "is vec3, not float");
    CHECK_THROWS_AS(program.set("a_float", 1), Error);
    CHECK_THROWS_AS(program.set("an_array[2]", 1.0f), Error);
}
