// SPDX-License-Identifier: MIT
// Saving and restoring a host's program.
#include "gl/host_program.hpp"

namespace nicol::gl {

HostProgram::HostProgram(const Context::State& state)
    : gl_(state.gl), program_(static_cast<GLuint>(state.integer(GL_CURRENT_PROGRAM))) {
    const GLint pipeline = program_ == 0 ? state.integer(GL_PROGRAM_PIPELINE_BINDING) : 0;
    for (std::size_t i = 0; i < kStages.size(); ++i) {
        auto program = static_cast<GLint>(program_);
        if (pipeline != 0) gl_.GetProgramPipelineiv(static_cast<GLuint>(pipeline), kStages[i], &program);
        if (program == 0) continue;
        GLint locations = 0;
        gl_.GetProgramStageiv(static_cast<GLuint>(program), kStages[i],
                              GL_ACTIVE_SUBROUTINE_UNIFORM_LOCATIONS, &locations);
        subroutines_[i].resize(static_cast<std::size_t>(locations));
        for (GLint location = 0; location < locations; ++location) {
            gl_.GetUniformSubroutineuiv(kStages[i], location,
                                        &subroutines_[i][static_cast<std::size_t>(location)]);
        }
    }
}

void HostProgram::put_back() const {
    gl_.UseProgram(program_);
    for (std::size_t i = 0; i < kStages.size(); ++i) {
        const std::vector<GLuint>& chosen = subroutines_[i];
        if (!chosen.empty())
            gl_.UniformSubroutinesuiv(kStages[i], static_cast<GLsizei>(chosen.size()), chosen.data());
    }
}

}  // namespace nicol::gl
