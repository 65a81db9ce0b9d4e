// SPDX-License-Identifier: MIT
// The states of OpenGL 4.5 that an application can set, each with an unusual value.
#pragma once

#include <glad/gl.h>

#include <functional>
#include <string>
#include <vector>

namespace host_test {

struct UnusualState {
    std::string name;
    /// Gives the state an unusual value, or its initial one.
    std::function<void(const GladGLContext& gl, bool unusual)> set;
};
using UnusualStates = std::vector<UnusualState>;

[[nodiscard]] UnusualStates unusual_settings();
/// Returns bound objects, and operations begun and not ended. The objects exist until their context is
/// destroyed.
[[nodiscard]] UnusualStates unusual_bindings();
/// Returns states that only compatibility contexts have.
[[nodiscard]] UnusualStates unusual_old_settings();

/// A constant of OpenGL.
struct Constant {
    const char* name;
    GLenum value;
};
#define GL_CONSTANT(constant) \
    host_test::Constant {     \
#constant, constant   \
    }

inline void enable(const GladGLContext& gl, GLenum capability, bool on) {
    (on ? gl.Enable : gl.Disable)(capability);
}

}  // namespace host_test
