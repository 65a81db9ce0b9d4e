// SPDX-License-Identifier: MIT
#include "host/gl_program.hpp"
#include "host/unusual_state.hpp"

namespace host_test {
namespace {

using Gl = GladGLContext;

template <class Make>
GLuint made(Make make) {
    GLuint name = 0;
    make(1, &name);
    return name;
}

GLuint buffer_of(const Gl& gl) {
    const GLuint buffer = made(gl.CreateBuffers);
    gl.NamedBufferStorage(buffer, 4096, nullptr, 0);
    return buffer;
}

UnusualStates bindings() {
    UnusualStates states;
    for (const auto& [name, value] :
         {GL_CONSTANT(GL_ARRAY_BUFFER), GL_CONSTANT(GL_ATOMIC_COUNTER_BUFFER),
          GL_CONSTANT(GL_COPY_READ_BUFFER), GL_CONSTANT(GL_COPY_WRITE_BUFFER),
          GL_CONSTANT(GL_DISPATCH_INDIRECT_BUFFER), GL_CONSTANT(GL_DRAW_INDIRECT_BUFFER),
          GL_CONSTANT(GL_PIXEL_PACK_BUFFER), GL_CONSTANT(GL_PIXEL_UNPACK_BUFFER),
          GL_CONSTANT(GL_QUERY_BUFFER), GL_CONSTANT(GL_SHADER_STORAGE_BUFFER), GL_CONSTANT(GL_TEXTURE_BUFFER),
          GL_CONSTANT(GL_UNIFORM_BUFFER), GL_CONSTANT(GL_TRANSFORM_FEEDBACK_BUFFER)})
        states.push_back(
            {name, [value = value](const Gl& gl, bool on) { gl.BindBuffer(value, on ? buffer_of(gl) : 0); }});
    for (const auto& [name, value] :
         {GL_CONSTANT(GL_ATOMIC_COUNTER_BUFFER), GL_CONSTANT(GL_SHADER_STORAGE_BUFFER),
          GL_CONSTANT(GL_UNIFORM_BUFFER), GL_CONSTANT(GL_TRANSFORM_FEEDBACK_BUFFER)})
        for (GLuint i = 0; i < 4; i += 3)
            states.push_back(
                {std::string(name) + " " + std::to_string(i), [value = value, i](const Gl& gl, bool on) {
                     if (on)
                         gl.BindBufferRange(value, i, buffer_of(gl), 256, 512);
                     else
                         gl.BindBufferBase(value, i, 0);
                 }});
    states.push_back({"vertex array", [](const Gl& gl, bool on) {
                          const GLuint array = on ? made(gl.CreateVertexArrays) : 0;
                          gl.BindVertexArray(array);
                          if (!on) return;
                          const GLuint buffer = buffer_of(gl);
                          gl.VertexArrayElementBuffer(array, buffer);
                          gl.VertexArrayVertexBuffer(array, 1, buffer, 0, 64);
                          gl.VertexArrayBindingDivisor(array, 1, 3);
                          gl.EnableVertexArrayAttrib(array, 1);
                      }});
    states.push_back({"renderbuffer", [](const Gl& gl, bool on) {
                          gl.BindRenderbuffer(GL_RENDERBUFFER, on ? made(gl.CreateRenderbuffers) : 0);
                      }});
    states.push_back({"framebuffers", [](const Gl& gl, bool on) {
                          const GLuint target = on ? made(gl.CreateFramebuffers) : 0;
                          gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
                          gl.BindFramebuffer(GL_READ_FRAMEBUFFER, on ? made(gl.CreateFramebuffers) : 0);
                          if (!on) return;
                          const GLenum drawn[] = {GL_NONE, GL_COLOR_ATTACHMENT1};
                          gl.NamedFramebufferDrawBuffers(target, 2, drawn);
                          gl.ReadBuffer(GL_NONE);
                      }});
    states.push_back({"sampler", [](const Gl& gl, bool on) {
                          const GLuint sampler = on ? made(gl.CreateSamplers) : 0;
                          if (on) gl.SamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
                          for (GLuint unit = 0; unit < 32; ++unit) gl.BindSampler(unit, sampler);
                      }});
    states.push_back({"image units", [](const Gl& gl, bool on) {
                          GLuint texture = 0;
                          if (on) {
                              gl.CreateTextures(GL_TEXTURE_2D_ARRAY, 1, &texture);
                              gl.TextureStorage3D(texture, 3, GL_RGBA32F, 8, 8, 4);
                          }
                          for (GLuint unit = 0; unit < 8; ++unit)
                              gl.BindImageTexture(unit, texture, on ? 1 : 0, GL_FALSE, on ? 2 : 0,
                                                  on ? GL_READ_WRITE : GL_READ_ONLY, on ? GL_RGBA32F : GL_R8);
                      }});
    states.push_back({"active texture",
                      [](const Gl& gl, bool on) { gl.ActiveTexture(on ? GL_TEXTURE0 + 77 : GL_TEXTURE0); }});
    for (const auto& [name, value] :
         {GL_CONSTANT(GL_TEXTURE_1D), GL_CONSTANT(GL_TEXTURE_2D), GL_CONSTANT(GL_TEXTURE_3D),
          GL_CONSTANT(GL_TEXTURE_1D_ARRAY), GL_CONSTANT(GL_TEXTURE_2D_ARRAY),
          GL_CONSTANT(GL_TEXTURE_RECTANGLE), GL_CONSTANT(GL_TEXTURE_CUBE_MAP),
          GL_CONSTANT(GL_TEXTURE_CUBE_MAP_ARRAY), GL_CONSTANT(GL_TEXTURE_BUFFER),
          GL_CONSTANT(GL_TEXTURE_2D_MULTISAMPLE), GL_CONSTANT(GL_TEXTURE_2D_MULTISAMPLE_ARRAY)})
        states.push_back({std::string("bound ") + name, [value = value](const Gl& gl, bool on) {
                              GLuint texture = 0;
                              if (on) gl.CreateTextures(value, 1, &texture);
                              for (GLuint unit = 0; unit < 32; ++unit) {
                                  gl.ActiveTexture(GL_TEXTURE0 + unit);
                                  gl.BindTexture(value, texture);
                              }
                              gl.ActiveTexture(GL_TEXTURE0);
                          }});
    return states;
}

UnusualStates begun() {
    return {{"program", [](const Gl& gl, bool on) { gl.UseProgram(on ? program_of(gl) : 0); }},
            {"program pipeline",
             [](const Gl& gl, bool on) {
                 const GLuint pipeline = on ? made(gl.CreateProgramPipelines) : 0;
                 gl.BindProgramPipeline(pipeline);
                 if (!on) return;
                 const char* source = "#version 450\nout vec4 c; void main() { c = vec4(1); }";
                 gl.UseProgramStages(pipeline, GL_FRAGMENT_SHADER_BIT,
                                     gl.CreateShaderProgramv(GL_FRAGMENT_SHADER, 1, &source));
             }},
            {"paused transform feedback",
             [](const Gl& gl, bool on) {
                 if (on) {
                     gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, made(gl.CreateTransformFeedbacks));
                     gl.UseProgram(captured_program(gl));
                     gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer_of(gl));
                     gl.BeginTransformFeedback(GL_POINTS);
                     gl.PauseTransformFeedback();
                 } else {
                     gl.ResumeTransformFeedback();
                     gl.EndTransformFeedback();
                     gl.UseProgram(0);
                     gl.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
                     gl.BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
                 }
             }},
            {"active queries",
             [](const Gl& gl, bool on) {
                 for (const GLenum target : {GL_SAMPLES_PASSED, GL_PRIMITIVES_GENERATED,
                                             GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, GL_TIME_ELAPSED}) {
                     if (on) {
                         GLuint query = 0;
                         gl.CreateQueries(target, 1, &query);
                         gl.BeginQuery(target, query);
                     } else {
                         gl.EndQuery(target);
                     }
                 }
             }},
            {"debug group",
             [](const Gl& gl, bool on) {
                 if (on)
                     gl.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 1, -1, "frame");
                 else
                     gl.PopDebugGroup();
             }},
            {"debug callback", [](const Gl& gl, bool on) {
                 enable(gl, GL_DEBUG_OUTPUT, on);
                 const GLDEBUGPROC ignore = [](GLenum, GLenum, GLuint, GLenum, GLsizei, const GLchar*,
                                               const void*) {};
                 gl.DebugMessageCallback(on ? ignore : nullptr, nullptr);
             }}};
}

}  // namespace

UnusualStates unusual_bindings() {
    UnusualStates all = bindings();
    for (const UnusualState& state : begun()) all.push_back(state);
    return all;
}

}  // namespace host_test
