// SPDX-License-Identifier: MIT
// Save and restore of a host's program.
#include "gl/host_program.hpp"

namespace nicol::gl {

HostProgram::HostProgram(const Context::State& state)
    : gl_(state.gl), program_(static_cast<GLuint>(state.integer(GL_CURRENT_PROGRAM))) {
    const GLint pipeline = program_ == 0 ? state.integer(GL_PROGRAM_PIPELINE_BINDING) : 0;
    for (std::size_t i = 0; i < kStages.size(); ++i) {
        const auto [shader, subroutine_uniforms] = kStages[i];
        auto program = static_cast<GLint>(program_);
        if (pipeline != 0) gl_.GetProgramPipelineiv(static_cast<GLuint>(pipeline), shader, &program);
        if (program == 0) continue;
        const auto of_stage = static_cast<GLuint>(program);
        GLint uniforms = 0, locations = 0;
        // Mesa's glGetProgramStageiv fails if the program does not have the stage.
        gl_.GetProgramInterfaceiv(of_stage, subroutine_uniforms, GL_ACTIVE_RESOURCES, &uniforms);
        if (uniforms == 0) continue;
        gl_.GetProgramStageiv(of_stage, shader, GL_ACTIVE_SUBROUTINE_UNIFORM_LOCATIONS, &locations);
        for (GLint location = 0; location < locations; ++location) {
            gl_.GetUniformSubroutineuiv(shader, location, &subroutines_[i].emplace_back());
        }
    }
}

void HostProgram::put_back() const {
    gl_.UseProgram(program_);
    for (std::size_t i = 0; i < kStages.size(); ++i) {
        const std::vector<GLuint>& chosen = subroutines_[i];
        if (!chosen.empty())
            gl_.UniformSubroutinesuiv(kStages[i].shader, static_cast<GLsizei>(chosen.size()), chosen.data());
    }
}

}  // namespace nicol::gl
