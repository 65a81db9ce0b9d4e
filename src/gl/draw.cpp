// SPDX-License-Identifier: MIT
// Implementation of draw and dispatch calls.
#include "gl/draw.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <tuple>

#include "arguments.hpp"
#include "gl/host_state.hpp"
#include "gl/state.hpp"

namespace nicol::gl {
namespace {

void use(const Program& program) {
    Context::State& state = program.context()->state();
    state.bind_resources();
    if (state.used_program == program.id()) return;
    state.gl.UseProgram(program.id());
    state.used_program = program.id();
}

const GladGLContext& prepare(const char* what, RenderTarget& target, const Program& program,
                             const DrawState& state) {
    const GladGLContext& gl = functions(*target.context(), what);
    if (program.context() != target.context())
        refuse(std::string(what) + ": the program and the render target are of different contexts");
    if (program.is_compute()) refuse(std::string(what) + ": " + program.label() + " is a compute program");
    if (HostState* const host = target.context()->state().host_state) {
        host->prepare_drawing();
        host->prepare_program(false);
    }
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, target.id());
    gl.ViewportIndexedf(0, 0, 0, static_cast<GLfloat>(target.width()), static_cast<GLfloat>(target.height()));
    if (state.depth_test == DepthTest::off) {
        gl.Disable(GL_DEPTH_TEST);
    } else {
        gl.Enable(GL_DEPTH_TEST);
        const bool strictly = state.depth_test == DepthTest::nearer;
        if (state.reversed_depth) {
            gl.DepthFunc(strictly ? GL_GREATER : GL_GEQUAL);
        } else {
            gl.DepthFunc(strictly ? GL_LESS : GL_LEQUAL);
        }
    }
    gl.DepthMask(state.depth_write ? GL_TRUE : GL_FALSE);
    if (state.cull == Cull::none) {
        gl.Disable(GL_CULL_FACE);
    } else {
        gl.Enable(GL_CULL_FACE);
        gl.CullFace(state.cull == Cull::back ? GL_BACK : GL_FRONT);
    }
    const auto written = [&state](int component) -> GLboolean {
        return component < state.components ? GL_TRUE : GL_FALSE;
    };
    if (const HostState* const host = target.context()->state().host_state;
        host == nullptr || !host->restores())
        gl.ColorMask(written(0), written(1), written(2), written(3));
    else
        for (GLuint i = 0; i < static_cast<GLuint>(target.colours()); ++i)
            gl.ColorMaski(i, written(0), written(1), written(2), written(3));
    use(program);
    return gl;
}

}  // namespace

void draw(RenderTarget& target, const Program& program, const VertexArray& vertices, const DrawState& state) {
    draw(target, program, vertices, 0, vertices.index_count(), state);
}

void draw(RenderTarget& target, const Program& program, const VertexArray& vertices, std::size_t first,
          std::size_t count, const DrawState& state) {
    if (vertices.context() != target.context())
        refuse("draw: the vertex array and the render target are of different contexts");
    const std::size_t available = vertices.index_count();
    if (first > available || count > available - first || first % 3 != 0 || count % 3 != 0)
        refuse("draw: " + std::to_string(count) + " indices from " + std::to_string(first) +
               " are no whole triangles among " + std::to_string(available) + " indices");
    const GladGLContext& gl = prepare("draw", target, program, state);
    gl.BindVertexArray(vertices.id());
    // The indices are drawn in parts because OpenGL counts with 31 bits.
    constexpr std::size_t most = (std::numeric_limits<GLsizei>::max() / 3) * std::size_t{3};
    for (std::size_t done = 0; done < count; done += most) {
        const std::size_t offset = (first + done) * sizeof(GLuint);
        gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(std::min(most, count - done)), GL_UNSIGNED_INT,
                        reinterpret_cast<const void*>(offset));  // NOLINT(performance-no-int-to-ptr)
    }
    target.context()->state().check_command("drawing with " + program.label());
}

void draw_fullscreen(RenderTarget& target, const Program& program, const DrawState& state) {
    const GladGLContext& gl = prepare("draw_fullscreen", target, program, state);
    gl.BindVertexArray(target.context()->state().empty_vertex_array);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    target.context()->state().check_command("drawing with " + program.label());
}

void texture_barrier(Context& context) {
    functions(context, "texture_barrier").TextureBarrier();
}

void dispatch(const Program& program, unsigned x, unsigned y, unsigned z) {
    const GladGLContext& gl = functions(*program.context(), "dispatch");
    if (!program.is_compute()) refuse("dispatch: " + program.label() + " is not a compute program");
    const std::array<unsigned, 3> groups{x, y, z};
    const std::array<unsigned, 3>& limit = program.context()->limits().groups;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (groups[axis] == 0 || groups[axis] > limit[axis])
            refuse("dispatch: " + std::to_string(groups[axis]) + " work groups on axis " +
                   std::to_string(axis) + " are not between 1 and the limit of " +
                   std::to_string(limit[axis]));
    if (HostState* const host = program.context()->state().host_state) host->prepare_program(true);
    use(program);
    gl.DispatchCompute(x, y, z);
    Context::State& context = program.context()->state();
    if (context.independent_dispatches == 0) gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
    context.check_command("dispatching " + program.label());
}

IndependentDispatches::IndependentDispatches(Context& context) : context_(context) {
    std::ignore = functions(context_, "IndependentDispatches");
    ++context_.state().independent_dispatches;
}

IndependentDispatches::~IndependentDispatches() {
    if (--context_.state().independent_dispatches == 0)
        context_.state().gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
}

}  // namespace nicol::gl
