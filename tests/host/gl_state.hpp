// SPDX-License-Identifier: MIT
// Snapshots of a context's complete state by name, for comparisons before and after calls.
#pragma once

#include <glad/gl.h>

#include <map>
#include <string>
#include <vector>

namespace host_test {

using GlState = std::map<std::string, std::vector<double>>;

[[nodiscard]] GlState gl_state(const GladGLContext& gl);
/// Returns the names whose values differ, with both values.
[[nodiscard]] std::string difference(const GlState& before, const GlState& after);
/// Returns the existing object names, counted from 1, by kind.
[[nodiscard]] GlState gl_names(const GladGLContext& gl);

}  // namespace host_test
