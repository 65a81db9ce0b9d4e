// SPDX-License-Identifier: MIT
// Everything OpenGL tells of a context's state, by name, to compare before and after.
#pragma once

#include <glad/gl.h>

#include <map>
#include <string>
#include <vector>

namespace host_test {

using GlState = std::map<std::string, std::vector<double>>;

[[nodiscard]] GlState gl_state(const GladGLContext& gl);
/// Names whose values differ, with both values.
[[nodiscard]] std::string difference(const GlState& before, const GlState& after);
/// Which names from 1 on are objects, by kind.
[[nodiscard]] GlState gl_names(const GladGLContext& gl);

}  // namespace host_test
