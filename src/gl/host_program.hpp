// SPDX-License-Identifier: MIT
// Saved program of a host.
#pragma once

#include <array>
#include <vector>

#include "gl/state.hpp"

namespace nicol::gl {

/// The host's current program, and the subroutines chosen in the stages of the current program or pipeline;
/// glUseProgram resets these.
class HostProgram {
public:
    explicit HostProgram(const Context::State& state);
    void put_back() const;

private:
    struct Stage {
        GLenum shader, subroutine_uniforms;
    };
    static constexpr std::array<Stage, 6> kStages{
        {{GL_VERTEX_SHADER, GL_VERTEX_SUBROUTINE_UNIFORM},
         {GL_TESS_CONTROL_SHADER, GL_TESS_CONTROL_SUBROUTINE_UNIFORM},
         {GL_TESS_EVALUATION_SHADER, GL_TESS_EVALUATION_SUBROUTINE_UNIFORM},
         {GL_GEOMETRY_SHADER, GL_GEOMETRY_SUBROUTINE_UNIFORM},
         {GL_FRAGMENT_SHADER, GL_FRAGMENT_SUBROUTINE_UNIFORM},
         {GL_COMPUTE_SHADER, GL_COMPUTE_SUBROUTINE_UNIFORM}}};

    const GladGLContext& gl_;
    GLuint program_;
    std::array<std::vector<GLuint>, kStages.size()> subroutines_;  ///< by stage, then by location
};

}  // namespace nicol::gl
