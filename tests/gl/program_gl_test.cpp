// SPDX-License-Identifier: MIT
// Compiling, definitions, messages, uniforms.
#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <string>
#include <vector>

#include "error.hpp"
#include "gl/buffer.hpp"
#include "gl/contexts.hpp"
#include "gl/draw.hpp"
#include "gl/test_shaders.hpp"

using namespace nicol;
using namespace nicol::gl;

namespace {

template <class Call>
std::string message_of(ErrorCode code, Call call) {
    try {
        call();
    } catch (const Error& error) {
        CHECK(error.code() == code);
        return error.what();
    }
    FAIL("nothing was thrown");
    return {};
}

bool contains(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("definitions reach the shader and line numbers stay those of the file") {
    on_every_backend([](const std::shared_ptr<Context>& context) {
        context->run([&] {
            const std::array<Define, 2> defines{{{"WIDE", "3.5"}, {"HIGH", "(-1.0 / 4.0)"}}};
            const Program program = Program::graphics(context, embedded_shader("fullscreen.vert"),
                                                      test_shader("lines.frag"), defines);
            RenderTarget target(context, {1, 1, 1, false});
            draw_fullscreen(target, program);
            std::array<float, 4> pixel{};
            target.read(0, pixel);
            CHECK(pixel == std::array{6.0f, 42.0f, 3.5f, -0.25f});
        });
    });
}

TEST_CASE("a compile error names the original file and line") {
    on_every_backend([](const std::shared_ptr<Context>& context) {
        context->run([&] {
            for (const bool with_define : {false, true}) {
                const Define define{"ANY", "1"};
                const std::span<const Define> defines(&define, with_define ? 1 : 0);
                const std::string text = message_of(ErrorCode::opengl, [&] {
                    static_cast<void>(Program::graphics(context, embedded_shader("fullscreen.vert"),
                                                        test_shader("broken.frag"), defines));
                });
                CAPTURE(text);
                CHECK(contains(text, "the shader broken.frag does not compile"));
                CHECK(contains(text, "nested_bad.glsl:3:"));
                CHECK(contains(text, "undeclared_in_nested"));
                CHECK(contains(text, "broken.frag:7:"));
                CHECK(contains(text, "undeclared_in_main"));
            }
            // The context works afterwards.
            const std::array<Define, 2> defines{{{"WIDE", "0.0"}, {"HIGH", "0.0"}}};
            CHECK_NOTHROW(Program::graphics(context, embedded_shader("fullscreen.vert"),
                                            test_shader("lines.frag"), defines));
            CHECK(total_bytes(context->memory()) == 0);
        });
    });
}

TEST_CASE("a link error names the program") {
    on_every_backend([](const std::shared_ptr<Context>& context) {
        context->run([&] {
            const ShaderSource vertex{"mismatch.vert",
                                      "#version 450 core\nlayout(location = 0) out vec3 uv;\n"
                                      "void main() { uv = vec3(1); gl_Position = vec4(uv, 1); }\n"};
            const Define scale{"SCALE", "1.0"};
            const std::string text = message_of(ErrorCode::opengl, [&] {
                static_cast<void>(
                    Program::graphics(context, vertex, test_shader("gather.frag"), {&scale, 1}));
            });
            CHECK(contains(text, "mismatch.vert + gather.frag does not link"));
        });
    });
}

TEST_CASE("uniforms of every type arrive") {
    on_every_backend([](const std::shared_ptr<Context>& context) {
        context->run([&] {
            Program program = Program::compute(context, test_shader("uniforms.comp"));
            glm::mat3 m3;
            glm::mat4 m4;
            for (int i = 0; i < 9; ++i) glm::value_ptr(m3)[i] = 10.0f + static_cast<float>(i);
            for (int i = 0; i < 16; ++i) glm::value_ptr(m4)[i] = 20.0f + static_cast<float>(i);
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
            for (int i = 0; i < 9; ++i) expected.push_back(10.0f + static_cast<float>(i));
            for (int i = 0; i < 18; ++i) expected.push_back(20.0f + static_cast<float>(i));
            expected[expected.size() - 2] = 36.0f;
            expected[expected.size() - 1] = 37.0f;
            expected.push_back(42.0f);
            const Buffer output(context, BufferUse::storage, expected.size() * sizeof(float),
                                BufferUpdate::fixed);
            output.bind_storage(0);
            dispatch(program, 1);
            std::vector<float> result(expected.size());
            output.read(0, std::as_writable_bytes(std::span(result)));
            CHECK(result == expected);
        });
    });
}

TEST_CASE("a uniform of another name or type is an error that says what there is") {
    on_every_backend([](const std::shared_ptr<Context>& context) {
        context->run([&] {
            Program program = Program::compute(context, test_shader("uniforms.comp"));
            CHECK(program.uses("a_float"));
            CHECK(!program.uses("a_flaot"));
            const std::string name =
                message_of(ErrorCode::invalid_argument, [&] { program.set("a_flaot", 1.0f); });
            CHECK(contains(name, "a_flaot"));
            CHECK(contains(name, "uniforms.comp"));
            CHECK(contains(name, "a_float"));
            const std::string type =
                message_of(ErrorCode::invalid_argument, [&] { program.set("a_vec3", 1.0f); });
            CHECK(contains(type, "is vec3, not float"));
            CHECK_THROWS_AS(program.set("a_float", 1), Error);
            CHECK_THROWS_AS(program.set("an_array[2]", 1.0f), Error);
        });
    });
}
