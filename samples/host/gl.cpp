// SPDX-License-Identifier: MIT
#include "gl.hpp"

#include <array>
#include <string>

#include "common/failure.hpp"

Gl::Gl() {
#define HOST_GL_LOAD(member, type)                                                    \
    member = reinterpret_cast<decltype(member)>(SDL_GL_GetProcAddress("gl" #member)); \
    if (member == nullptr) throw Failure("this OpenGL has no gl" #member);
    HOST_GL_FUNCTIONS(HOST_GL_LOAD)
#undef HOST_GL_LOAD
}

GLuint Gl::program(const char* vertex, const char* fragment) const {
    const GLuint made = CreateProgram();
    for (const auto& [stage, text] :
         {std::pair(GL_VERTEX_SHADER, vertex), std::pair(GL_FRAGMENT_SHADER, fragment)}) {
        const GLuint shader = CreateShader(static_cast<GLenum>(stage));
        ShaderSource(shader, 1, &text, nullptr);
        CompileShader(shader);
        GLint done = GL_FALSE;
        GetShaderiv(shader, GL_COMPILE_STATUS, &done);
        if (done != GL_TRUE) {
            std::array<char, 512> log{};
            GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
            throw Failure(std::string("a shader does not compile: ") + log.data());
        }
        AttachShader(made, shader);
    }
    LinkProgram(made);
    return made;
}
