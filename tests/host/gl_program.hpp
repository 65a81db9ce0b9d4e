// SPDX-License-Identifier: MIT
// OpenGL programs of the application.
#pragma once

#include <glad/gl.h>

#include <initializer_list>
#include <utility>

namespace host_test {

using Shaders = std::initializer_list<std::pair<GLenum, const char*>>;

inline void attach_and_link(const GladGLContext& gl, GLuint program, Shaders shaders) {
    for (const auto& [stage, source] : shaders) {
        const GLuint shader = gl.CreateShader(stage);
        gl.ShaderSource(shader, 1, &source, nullptr);
        gl.CompileShader(shader);
        gl.AttachShader(program, shader);
        gl.DeleteShader(shader);
    }
    gl.LinkProgram(program);
}

inline GLuint program_of(const GladGLContext& gl, Shaders shaders) {
    const GLuint program = gl.CreateProgram();
    attach_and_link(gl, program, shaders);
    return program;
}

inline GLuint program_of(const GladGLContext& gl) {
    return program_of(gl,
                      {{GL_VERTEX_SHADER, "#version 450\nvoid main() { gl_Position = vec4(0, 0, 0, 1); }"},
                       {GL_FRAGMENT_SHADER, "#version 450\nout vec4 c; void main() { c = vec4(1); }"}});
}

/// Returns a program whose vertices transform feedback can capture.
inline GLuint captured_program(const GladGLContext& gl) {
    return program_of(gl, {{GL_VERTEX_SHADER,
                            "#version 450\nlayout(xfb_buffer = 0, xfb_offset = 0) out vec4 v;"
                            "void main() { v = vec4(1); gl_Position = v; }"}});
}

}  // namespace host_test
