// SPDX-License-Identifier: MIT
// OpenGL's state, to check that the library restores it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "gl.hpp"

using GlState = std::map<std::string, std::vector<double>>;

[[nodiscard]] GlState gl_state(const Gl& gl);
/// Returns a text such as "GL_BLEND was 1, is 0; ...", empty if nothing differs.
[[nodiscard]] std::string difference(const GlState& before, const GlState& after);
