// SPDX-License-Identifier: MIT
// Draw and dispatch calls: each sets all the state it depends on.
#pragma once

#include <array>
#include <cstddef>

#include "gl/program.hpp"
#include "gl/render_target.hpp"
#include "gl/vertex_array.hpp"

namespace nicol::gl {

enum class DepthTest { off, less, less_equal };
enum class Cull { none, back, front };  ///< front faces are counter-clockwise in clip space

struct DrawState {
    DepthTest depth_test = DepthTest::less;  ///< `off` also keeps the depth buffer as it is
    bool depth_write = true;
    Cull cull = Cull::none;
    int components = 4;  ///< 1..4: the first so many of each texel are written, the others kept
};

/// All below inside run(); objects of different contexts, or a program of the wrong kind, are
/// Error(invalid_argument). Textures and storage are bound beforehand (Texture2D::bind,
/// Buffer::bind_storage).

/// Draws all triangles into the whole target.
void draw(RenderTarget& target, const Program& program, const VertexArray& vertices,
          const DrawState& state = {});
/// Draws `count` indices from `first`, both multiples of three, inside the index buffer.
void draw(RenderTarget& target, const Program& program, const VertexArray& vertices, std::size_t first,
          std::size_t count, const DrawState& state = {});
/// Runs the fragment shader once a pixel. The vertex shader is glsl/fullscreen.vert or one like it: three
/// vertices by gl_VertexID, no attributes.
void draw_fullscreen(RenderTarget& target, const Program& program,
                     const DrawState& state = {DepthTest::off, false, Cull::none});
/// What was drawn before can be read by a later fragment shader, even by one that draws into the same target:
/// each invocation its own texel.
void texture_barrier(Context& context);
/// Runs x * y * z work groups; what they wrote is visible to everything after.
void dispatch(const Program& program, unsigned x, unsigned y = 1, unsigned z = 1);

}  // namespace nicol::gl
