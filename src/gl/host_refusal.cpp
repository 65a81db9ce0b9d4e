// SPDX-License-Identifier: MIT
// Queries of the states that are refused.
#include "gl/host_refusal.hpp"

#include "error.hpp"

namespace nicol::gl {
namespace {

// State of compatibility contexts, for which the core loader has no names.
constexpr GLenum kListIndex = 0x0B33, kRenderMode = 0x0C40;
constexpr GLint kRender = 0x1C00;

[[noreturn]] void refuse_state(const char* text) {
    throw Error(ErrorCode::unsupported, text);
}

void require_lasting_program(const Context::State& state) {
    const auto program = static_cast<GLuint>(state.integer(GL_CURRENT_PROGRAM));
    if (program == 0) return;
    GLint deleted = GL_FALSE, linked = GL_TRUE;
    state.gl.GetProgramiv(program, GL_DELETE_STATUS, &deleted);
    state.gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (deleted == GL_TRUE)
        refuse_state(
            "the host's current program is deleted and would be gone once another one is used; use another "
            "or none around calls of Nicol");
    if (linked != GL_TRUE)
        refuse_state(
            "the host's current program failed to link again and what it was would be gone once another one "
            "is used; use another or none around calls of Nicol");
}

}  // namespace

void require_drawable(const Context::State& state) {
    GLboolean active = GL_FALSE, paused = GL_FALSE;
    state.gl.GetBooleanv(GL_TRANSFORM_FEEDBACK_ACTIVE, &active);
    state.gl.GetBooleanv(GL_TRANSFORM_FEEDBACK_PAUSED, &paused);
    if (active == GL_TRUE && paused == GL_FALSE)
        refuse_state("the host's transform feedback is active; end or pause it around calls of Nicol");
    if (state.compatibility && state.integer(kListIndex) != 0)
        refuse_state("the host compiles a display list; end it around calls of Nicol");
    if (state.compatibility && state.integer(kRenderMode) != kRender)
        refuse_state("the host's render mode is not GL_RENDER; return to it around calls of Nicol");
    require_lasting_program(state);
}

void require_unconditional(const Context::State& state) {
    // No query tells of conditional rendering, but it cannot be begun twice.
    state.gl.BeginConditionalRender(state.condition, GL_QUERY_NO_WAIT);
    if (state.gl.GetError() != GL_NO_ERROR)
        refuse_state("the host renders conditionally; end that around calls of Nicol");
    state.gl.EndConditionalRender();
}

}  // namespace nicol::gl
