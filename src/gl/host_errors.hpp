// SPDX-License-Identifier: MIT
// Errors that a host left pending in its context.
#pragma once

#include <vector>

#include "gl/state.hpp"

namespace nicol::gl {

/// Takes the host's pending errors on construction, so that errors found later are this library's, and makes
/// them pending again on destruction: the host's next glGetError returns what it would have returned without
/// the call.
class HostErrors {
public:
    /// Throws Error(opengl) for an error that cannot be made pending again: GL_STACK_OVERFLOW,
    /// GL_STACK_UNDERFLOW or GL_CONTEXT_LOST.
    explicit HostErrors(const GladGLContext& gl);
    ~HostErrors();
    HostErrors(const HostErrors&) = delete;
    HostErrors& operator=(const HostErrors&) = delete;

private:
    void put_back() const;

    const GladGLContext& gl_;
    std::vector<GLenum> pending_;
};

}  // namespace nicol::gl
