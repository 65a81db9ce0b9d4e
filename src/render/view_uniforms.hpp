// SPDX-License-Identifier: MIT
// A viewpoint for shaders.
#pragma once

#include "gl/program.hpp"
#include "polarization/viewpoint.hpp"

namespace nicol {

/// Sets those uniforms of glsl/vertex_view.glsl that the program uses.
void set_view_uniforms(gl::Program& program, const Viewpoint& view);

}  // namespace nicol
