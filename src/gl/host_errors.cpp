// SPDX-License-Identifier: MIT
#include "gl/host_errors.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "error.hpp"

namespace nicol::gl {
namespace {

constexpr int kMostErrors = 8;  // a lost context reports errors without end

constexpr std::array<GLenum, 5> kProvokable{GL_INVALID_ENUM, GL_INVALID_VALUE, GL_INVALID_OPERATION,
                                            GL_INVALID_FRAMEBUFFER_OPERATION, GL_OUT_OF_MEMORY};

void provoke(const GladGLContext& gl, GLenum error) {
    GLuint name = 0;
    switch (error) {
        case GL_INVALID_ENUM:
            gl.Enable(GL_NONE);
            break;
        case GL_INVALID_VALUE:
            gl.LineWidth(0);
            break;
        case GL_INVALID_OPERATION:
            gl.BindVertexArray(std::numeric_limits<GLuint>::max());  // no driver has given this name
            break;
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            gl.CreateFramebuffers(1, &name);
            gl.BlitNamedFramebuffer(name, name, 0, 0, 1, 1, 0, 0, 1, 1, GL_COLOR_BUFFER_BIT, GL_NEAREST);
            gl.DeleteFramebuffers(1, &name);
            break;
        default:  // GL_OUT_OF_MEMORY
            gl.CreateBuffers(1, &name);
            gl.NamedBufferStorage(name, PTRDIFF_MAX, nullptr, 0);
            gl.DeleteBuffers(1, &name);
            break;
    }
}

}  // namespace

HostErrors::HostErrors(const GladGLContext& gl) : gl_(gl) {
    for (int i = 0; i < kMostErrors; ++i) {
        const GLenum error = gl_.GetError();
        if (error == GL_NO_ERROR) return;
        if (std::ranges::find(kProvokable, error) == kProvokable.end()) {
            put_back();
            throw Error(ErrorCode::opengl,
                        "the host left " + error_name(error) +
                            " pending in its OpenGL context, which Nicol took and cannot make pending again");
        }
        pending_.push_back(error);
    }
}

HostErrors::~HostErrors() {
    for (int i = 0; i < kMostErrors && gl_.GetError() != GL_NO_ERROR; ++i) {
        // The call has reported its own errors.
    }
    put_back();
}

void HostErrors::put_back() const {
    if (pending_.empty()) return;
    const GLboolean debug = gl_.IsEnabled(GL_DEBUG_OUTPUT);
    gl_.Disable(GL_DEBUG_OUTPUT);  // the driver has already told the host
    for (const GLenum error : pending_) provoke(gl_, error);
    if (debug == GL_TRUE) gl_.Enable(GL_DEBUG_OUTPUT);
}

}  // namespace nicol::gl
