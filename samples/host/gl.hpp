// SPDX-License-Identifier: MIT
// The OpenGL functions of this application, loaded by SDL.
#pragma once

#include <SDL.h>
#include <SDL_opengl.h>

/// Calls X(member, type) for each function glMember of that type.
#define HOST_GL_FUNCTIONS(X)                                     \
    X(ActiveTexture, PFNGLACTIVETEXTUREPROC)                     \
    X(AttachShader, PFNGLATTACHSHADERPROC)                       \
    X(BindFramebuffer, PFNGLBINDFRAMEBUFFERPROC)                 \
    X(BindTexture, decltype(&::glBindTexture))                   \
    X(BindVertexArray, PFNGLBINDVERTEXARRAYPROC)                 \
    X(BlendFunc, decltype(&::glBlendFunc))                       \
    X(BufferData, PFNGLBUFFERDATAPROC)                           \
    X(BindBuffer, PFNGLBINDBUFFERPROC)                           \
    X(Clear, decltype(&::glClear))                               \
    X(ClearColor, decltype(&::glClearColor))                     \
    X(CompileShader, PFNGLCOMPILESHADERPROC)                     \
    X(CreateProgram, PFNGLCREATEPROGRAMPROC)                     \
    X(CreateShader, PFNGLCREATESHADERPROC)                       \
    X(Disable, decltype(&::glDisable))                           \
    X(DrawArrays, decltype(&::glDrawArrays))                     \
    X(Enable, decltype(&::glEnable))                             \
    X(EnableVertexAttribArray, PFNGLENABLEVERTEXATTRIBARRAYPROC) \
    X(FramebufferTexture2D, PFNGLFRAMEBUFFERTEXTURE2DPROC)       \
    X(GenBuffers, PFNGLGENBUFFERSPROC)                           \
    X(GenFramebuffers, PFNGLGENFRAMEBUFFERSPROC)                 \
    X(GenTextures, decltype(&::glGenTextures))                   \
    X(GenVertexArrays, PFNGLGENVERTEXARRAYSPROC)                 \
    X(GetDoublei_v, PFNGLGETDOUBLEI_VPROC)                       \
    X(GetDoublev, decltype(&::glGetDoublev))                     \
    X(GetError, decltype(&::glGetError))                         \
    X(GetIntegerv, decltype(&::glGetIntegerv))                   \
    X(GetShaderInfoLog, PFNGLGETSHADERINFOLOGPROC)               \
    X(GetShaderiv, PFNGLGETSHADERIVPROC)                         \
    X(GetUniformLocation, PFNGLGETUNIFORMLOCATIONPROC)           \
    X(IsEnabled, decltype(&::glIsEnabled))                       \
    X(IsEnabledi, PFNGLISENABLEDIPROC)                           \
    X(LinkProgram, PFNGLLINKPROGRAMPROC)                         \
    X(PixelStorei, decltype(&::glPixelStorei))                   \
    X(ReadPixels, decltype(&::glReadPixels))                     \
    X(Scissor, decltype(&::glScissor))                           \
    X(ShaderSource, PFNGLSHADERSOURCEPROC)                       \
    X(TexParameteri, decltype(&::glTexParameteri))               \
    X(TexStorage2D, PFNGLTEXSTORAGE2DPROC)                       \
    X(Uniform1f, PFNGLUNIFORM1FPROC)                             \
    X(UseProgram, PFNGLUSEPROGRAMPROC)                           \
    X(VertexAttribPointer, PFNGLVERTEXATTRIBPOINTERPROC)         \
    X(Viewport, decltype(&::glViewport))

struct Gl {
#define HOST_GL_MEMBER(member, type) type member = nullptr;
    HOST_GL_FUNCTIONS(HOST_GL_MEMBER)
#undef HOST_GL_MEMBER

    /// Loads the functions of the current context. Throws Failure naming a missing function.
    Gl();
    /// Links a program. Throws Failure with the compiler's log.
    [[nodiscard]] GLuint program(const char* vertex, const char* fragment) const;
};
