// SPDX-License-Identifier: MIT
// Compilation, linking and uniforms.
#include "gl/program.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "error.hpp"
#include "gl/program_cache.hpp"
#include "gl/state.hpp"

namespace nicol::gl {
namespace {

/// Returns the info log of a shader or program.
template <class GetInteger, class GetLog>
std::string log_of(GLuint id, GetInteger get_integer, GetLog get_log) {
    GLint length = 0;
    get_integer(id, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    GLsizei written = 0;
    get_log(id, static_cast<GLsizei>(log.size()), &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    return log;
}

Object compiled(const std::shared_ptr<Context>& context, GLenum type, const ShaderSource& source,
                std::span<const Define> defines) {
    const std::string text = with_defines(source, defines);
    Object shader(context, ObjectKind::shader, type);
    const GladGLContext& gl = functions(*context, "compiling a shader");
    const char* begin = text.data();
    const auto length = static_cast<GLint>(text.size());
    gl.ShaderSource(shader.id(), 1, &begin, &length);
    gl.CompileShader(shader.id());
    GLint done = GL_FALSE;
    gl.GetShaderiv(shader.id(), GL_COMPILE_STATUS, &done);
    if (done != GL_TRUE) {
        context->state().messages.clear();  // the messages repeat the log without file names
        throw Error(ErrorCode::opengl,
                    "the shader " + std::string(source.file) + " does not compile:\n" +
                        with_file_names(source, log_of(shader.id(), gl.GetShaderiv, gl.GetShaderInfoLog)));
    }
    context->state().check("compiling " + std::string(source.file));
    return shader;
}

std::string glsl_name(GLenum type) {
    switch (type) {
        case GL_INT:
            return "int";
        case GL_BOOL:
            return "bool";
        case GL_UNSIGNED_INT:
            return "uint";
        case GL_FLOAT:
            return "float";
        case GL_FLOAT_VEC2:
            return "vec2";
        case GL_FLOAT_VEC3:
            return "vec3";
        case GL_FLOAT_VEC4:
            return "vec4";
        case GL_FLOAT_MAT3:
            return "mat3";
        case GL_FLOAT_MAT4:
            return "mat4";
        case GL_SAMPLER_2D:
            return "sampler2D";
        case GL_IMAGE_2D:
            return "image2D";
        default:
            return "of type " + std::to_string(type);
    }
}

bool accepts(GLenum declared, GLenum given) {
    return declared == given ||
           (given == GL_INT && (declared == GL_BOOL || declared == GL_SAMPLER_2D || declared == GL_IMAGE_2D));
}

}  // namespace

Program Program::graphics(std::shared_ptr<Context> context, std::string_view vertex_file,
                          std::string_view fragment_file, std::span<const Define> defines) {
    return graphics(std::move(context), embedded_shader(vertex_file), embedded_shader(fragment_file),
                    defines);
}

Program Program::graphics(std::shared_ptr<Context> context, const ShaderSource& vertex,
                          const ShaderSource& fragment, std::span<const Define> defines) {
    const std::array<Stage, 2> stages{{{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}};
    return {std::move(context), stages, defines};
}

Program Program::compute(std::shared_ptr<Context> context, std::string_view file,
                         std::span<const Define> defines) {
    return compute(std::move(context), embedded_shader(file), defines);
}

Program Program::compute(std::shared_ptr<Context> context, const ShaderSource& source,
                         std::span<const Define> defines) {
    const std::array<Stage, 1> stages{{{GL_COMPUTE_SHADER, source}}};
    return {std::move(context), stages, defines};
}

Program::Program(std::shared_ptr<Context> context, std::span<const Stage> stages,
                 std::span<const Define> defines)
    : object_(std::move(context), ObjectKind::program), compute_(stages.front().type == GL_COMPUTE_SHADER) {
    const GladGLContext& gl = functions(*this->context(), "linking a program");
    const ProgramCache cache(*this->context());
    ProgramKey key;
    for (const Stage& stage : stages) {
        label_ += (label_.empty() ? "" : " + ") + std::string(stage.source.file);
        if (cache.enabled()) key.add(stage.type, with_defines(stage.source, defines));
    }
    if (cache.load(key, id())) {
        find_uniforms();
        this->context()->state().check("loading " + label_);
        return;
    }
    for (const Stage& stage : stages) {
        const Object shader = compiled(this->context(), stage.type, stage.source, defines);
        gl.AttachShader(id(), shader.id());  // keeps the shader until the program is deleted
    }
    if (cache.enabled()) gl.ProgramParameteri(id(), GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
    gl.LinkProgram(id());
    GLint done = GL_FALSE;
    gl.GetProgramiv(id(), GL_LINK_STATUS, &done);
    if (done != GL_TRUE) {
        this->context()->state().messages.clear();
        throw Error(ErrorCode::opengl, "the program " + label_ + " does not link:\n" +
                                           log_of(id(), gl.GetProgramiv, gl.GetProgramInfoLog));
    }
    find_uniforms();
    this->context()->state().check("linking " + label_);
    cache.store(key, id());
}

void Program::find_uniforms() {
    const GladGLContext& gl = functions(*context(), "Program");
    GLint count = 0, longest = 0;
    gl.GetProgramiv(id(), GL_ACTIVE_UNIFORMS, &count);
    gl.GetProgramiv(id(), GL_ACTIVE_UNIFORM_MAX_LENGTH, &longest);
    for (GLint i = 0; i < count; ++i) {
        std::string name(static_cast<std::size_t>(std::max(longest, 1)), '\0');
        GLsizei length = 0;
        GLint elements = 0;
        GLenum type = 0;
        gl.GetActiveUniform(id(), static_cast<GLuint>(i), longest, &length, &elements, &type, name.data());
        name.resize(static_cast<std::size_t>(length));
        const bool array = name.ends_with("[0]");
        const std::string base = array ? name.substr(0, name.size() - 3) : name;
        for (GLint element = 0; element < elements; ++element) {
            const std::string full = array ? base + '[' + std::to_string(element) + ']' : base;
            const GLint location = gl.GetUniformLocation(id(), full.c_str());
            if (location >= 0) uniforms_[full] = {location, type};  // members of blocks have no location
        }
    }
}

Program::Uniform& Program::find(std::string_view name, unsigned type) {
    const auto found = uniforms_.find(name);
    const auto refuse = [&](const std::string& text) {
        throw Error(ErrorCode::invalid_argument,
                    "the uniform \"" + std::string(name) + "\" of " + label_ + text);
    };
    if (found == uniforms_.end()) {
        std::string used;
        for (const auto& [known, uniform] : uniforms_) used += (used.empty() ? "" : ", ") + known;
        refuse(" does not exist; used are: " + (used.empty() ? "none" : used));
    }
    if (!accepts(found->second.type, type))
        refuse(" is " + glsl_name(found->second.type) + ", not " + glsl_name(type));
    return found->second;
}

template <class Value, class Set>
void Program::update(std::string_view name, unsigned type, const Value& value, Set set) {
    const GladGLContext& gl = functions(*context(), "Program::set");
    Uniform& uniform = find(name, type);
    static_assert(sizeof(Value) <= sizeof(uniform.last));
    const auto bytes = std::as_bytes(std::span(&value, 1));
    if (uniform.known && std::ranges::equal(bytes, std::span(uniform.last).first(bytes.size()))) return;
    uniform.known = false;  // what sets it may fail after OpenGL has taken it
    set(gl, uniform.location);
    std::ranges::copy(bytes, uniform.last.begin());
    uniform.known = true;
}

void Program::set(std::string_view name, int value) {
    update(name, GL_INT, value, [&](const GladGLContext& gl, GLint location) {
        gl.ProgramUniform1i(id(), location, value);
        context()->state().check_command("setting " +
                                         std::string(name));  // a too high unit of a sampler fails here
    });
}

void Program::set(std::string_view name, unsigned value) {
    update(name, GL_UNSIGNED_INT, value,
           [&](const GladGLContext& gl, GLint location) { gl.ProgramUniform1ui(id(), location, value); });
}

void Program::set(std::string_view name, float value) {
    update(name, GL_FLOAT, value,
           [&](const GladGLContext& gl, GLint location) { gl.ProgramUniform1f(id(), location, value); });
}

void Program::set(std::string_view name, const glm::vec2& value) {
    update(name, GL_FLOAT_VEC2, value, [&](const GladGLContext& gl, GLint location) {
        gl.ProgramUniform2fv(id(), location, 1, &value.x);
    });
}

void Program::set(std::string_view name, const glm::vec3& value) {
    update(name, GL_FLOAT_VEC3, value, [&](const GladGLContext& gl, GLint location) {
        gl.ProgramUniform3fv(id(), location, 1, &value.x);
    });
}

void Program::set(std::string_view name, const glm::ivec2& value) {
    update(name, GL_INT_VEC2, value, [&](const GladGLContext& gl, GLint location) {
        gl.ProgramUniform2iv(id(), location, 1, &value.x);
    });
}

void Program::set(std::string_view name, const glm::ivec3& value) {
    update(name, GL_INT_VEC3, value, [&](const GladGLContext& gl, GLint location) {
        gl.ProgramUniform3iv(id(), location, 1, &value.x);
    });
}

void Program::set(std::string_view name, const glm::vec4& value) {
    update(name, GL_FLOAT_VEC4, value, [&](const GladGLContext& gl, GLint location) {
        gl.ProgramUniform4fv(id(), location, 1, &value.x);
    });
}

void Program::set(std::string_view name, const glm::mat3& value) {
    update(name, GL_FLOAT_MAT3, value, [&](const GladGLContext& gl, GLint location) {
        gl.ProgramUniformMatrix3fv(id(), location, 1, GL_FALSE, &value[0].x);
    });
}

void Program::set(std::string_view name, const glm::mat4& value) {
    update(name, GL_FLOAT_MAT4, value, [&](const GladGLContext& gl, GLint location) {
        gl.ProgramUniformMatrix4fv(id(), location, 1, GL_FALSE, &value[0].x);
    });
}

}  // namespace nicol::gl
