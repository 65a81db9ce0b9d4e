// SPDX-License-Identifier: MIT
// Draw and dispatch calls. Each call sets all the state that it depends on.
#pragma once

#include <array>
#include <cstddef>

#include "gl/program.hpp"
#include "gl/render_target.hpp"
#include "gl/vertex_array.hpp"

namespace nicol::gl {

/// Depth is reversed, 1 at the near plane and 0 at the far plane: floats near 0 are dense, so distance keeps
/// about the same relative precision everywhere.
enum class DepthTest { off, nearer, nearer_or_equal };
enum class Cull { none, back, front };  ///< front faces are counter-clockwise in clip space

struct DrawState {
    DepthTest depth_test = DepthTest::nearer;  ///< `off` also leaves the depth buffer unchanged
    bool depth_write = true;
    Cull cull = Cull::none;
    int components = 4;  ///< 1..4: number of components of each texel that are written; the others are kept
    bool reversed_depth = true;  ///< false: the target's depth is a host's that grows with distance
};

/// All functions below must be called inside run(). Objects of different contexts, or a program of the wrong
/// kind, throw Error(invalid_argument). Textures and storage are bound beforehand (Texture2D::bind,
/// Buffer::bind_storage).

/// Draws all triangles into the whole target.
void draw(RenderTarget& target, const Program& program, const VertexArray& vertices,
          const DrawState& state = {});
/// Draws `count` indices from `first`, both multiples of three, inside the index buffer.
void draw(RenderTarget& target, const Program& program, const VertexArray& vertices, std::size_t first,
          std::size_t count, const DrawState& state = {});
/// Runs the fragment shader once per pixel. The vertex shader must be glsl/fullscreen.vert or similar: three
/// vertices by gl_VertexID, no attributes.
void draw_fullscreen(RenderTarget& target, const Program& program,
                     const DrawState& state = {DepthTest::off, false, Cull::none});
/// Makes earlier draws visible to later fragment shaders, even to one that draws into the same target if each
/// invocation reads its own texel only.
void texture_barrier(Context& context);
/// Runs x * y * z work groups; their writes are visible to all later commands.
void dispatch(const Program& program, unsigned x, unsigned y = 1, unsigned z = 1);

/// Lets dispatches run at the same time while it lives: none of them may read or write what another one
/// writes. Their writes are visible to all commands that follow it, or that follow one that encloses it.
class IndependentDispatches {
public:
    explicit IndependentDispatches(Context& context);
    ~IndependentDispatches();
    IndependentDispatches(const IndependentDispatches&) = delete;
    IndependentDispatches& operator=(const IndependentDispatches&) = delete;

private:
    Context& context_;
};

}  // namespace nicol::gl
