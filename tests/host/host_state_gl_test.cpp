// SPDX-License-Identifier: MIT
// Tests that calls preserve an application's OpenGL state, however unusual, and that the state does not
// affect the image.
#include <functional>

#include "host/egl_host.hpp"
#include "host/gl_program.hpp"
#include "host/gl_state.hpp"

using namespace host_test;

namespace {

/// Changes every state from its initial value. Most of the changes would spoil an image drawn with them.
void disarrange(const GladGLContext& gl) {
    if (profile_under_test == Profile::compatibility) {
        gl.Enable(0x0BC0);               // GL_ALPHA_TEST
        gl.Enable(0x0B42);               // GL_POLYGON_STIPPLE
        gl.ClampColor(0x891B, GL_TRUE);  // GL_CLAMP_FRAGMENT_COLOR
        const auto function = [](const char* name) { return egl().proc_address(name); };
        const auto transfer = reinterpret_cast<void (*)(GLenum, GLfloat)>(function("glPixelTransferf"));
        transfer(0x0D14, 0.25F);  // GL_RED_SCALE
        transfer(0x0D1B, 0.5F);   // GL_BLUE_BIAS
        reinterpret_cast<void (*)(GLenum, GLfloat)>(function("glAlphaFunc"))(GL_NEVER, 0);
        const GLubyte stipple[128] = {};
        reinterpret_cast<void (*)(const GLubyte*)>(function("glPolygonStipple"))(stipple);
    }
    for (const GLenum capability :
         {GL_STENCIL_TEST, GL_COLOR_LOGIC_OP, GL_POLYGON_OFFSET_FILL, GL_POLYGON_SMOOTH,
          GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE, GL_SAMPLE_MASK,
          GL_SAMPLE_SHADING, GL_PRIMITIVE_RESTART, GL_PRIMITIVE_RESTART_FIXED_INDEX, GL_RASTERIZER_DISCARD,
          GL_DEPTH_CLAMP, GL_FRAMEBUFFER_SRGB, GL_CULL_FACE, GL_CLIP_DISTANCE0, GL_CLIP_DISTANCE5})
        gl.Enable(capability);
    gl.PrimitiveRestartIndex(2);
    gl.LogicOp(GL_INVERT);
    gl.StencilFunc(GL_NEVER, 1, 0xff);
    gl.DepthFunc(GL_NEVER);
    gl.DepthMask(GL_FALSE);
    gl.CullFace(GL_FRONT_AND_BACK);
    gl.FrontFace(GL_CW);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    gl.PolygonOffset(3, 7);
    gl.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
    gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    for (GLuint i = 0; i < 8; ++i) {
        if (i % 3 == 0) gl.Enablei(GL_BLEND, i);
        if (i % 4 != 1) gl.Enablei(GL_SCISSOR_TEST, i);
        gl.BlendFuncSeparatei(i, GL_ZERO, GL_ONE_MINUS_SRC1_COLOR, GL_ONE, GL_SRC1_ALPHA);
        gl.BlendEquationSeparatei(i, GL_MAX, i % 2 == 0 ? GL_MIN : GL_FUNC_SUBTRACT);
        gl.ColorMaski(i, i % 2 == 0, i % 3 == 0, GL_FALSE, i % 2 == 1);
        const auto n = static_cast<float>(i);
        gl.ViewportIndexedf(i, n, 2 * n, 3, 4 + n);
        gl.ScissorIndexed(i, static_cast<GLint>(i), 1, 2, 1);
        gl.DepthRangeIndexed(i, 0.5, 0.25 + 0.01 * n);
    }
    for (const GLenum store :
         {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_PACK_IMAGE_HEIGHT,
          GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_IMAGE_HEIGHT,
          GL_PACK_SWAP_BYTES, GL_UNPACK_SWAP_BYTES})
        gl.PixelStorei(store, 1);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 8);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 2);

    std::array<GLuint, 4> buffers{};
    gl.CreateBuffers(4, buffers.data());
    for (const GLuint buffer : buffers) gl.NamedBufferStorage(buffer, 4096, nullptr, 0);
    gl.BindBuffer(GL_PIXEL_PACK_BUFFER, buffers[0]);
    gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, buffers[1]);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffers[2]);
    gl.BindBufferRange(GL_SHADER_STORAGE_BUFFER, 0, buffers[2], 256, 512);
    gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, buffers[3]);
    gl.BindBufferRange(GL_SHADER_STORAGE_BUFFER, 15, buffers[0], 0, 64);
    gl.BindBufferBase(GL_UNIFORM_BUFFER, 0, buffers[1]);
    gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffers[1]);

    std::array<GLuint, 3> textures{};
    gl.CreateTextures(GL_TEXTURE_2D, 2, textures.data());
    gl.CreateTextures(GL_TEXTURE_CUBE_MAP, 1, &textures[2]);
    for (const GLuint texture : textures) gl.TextureStorage2D(texture, 2, GL_RGBA32F, 4, 4);
    GLuint sampler = 0;
    gl.CreateSamplers(1, &sampler);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl.SamplerParameteri(sampler, filter, GL_NEAREST);
    for (GLuint unit = 0; unit < 20; ++unit) {
        gl.ActiveTexture(GL_TEXTURE0 + unit);
        if (unit % 3 != 1) gl.BindTexture(GL_TEXTURE_2D, textures[unit % 2]);
        if (unit % 4 != 2) gl.BindTexture(GL_TEXTURE_CUBE_MAP, textures[2]);
        if (unit % 2 == 0) gl.BindSampler(unit, sampler);
    }
    gl.ActiveTexture(GL_TEXTURE7);
    for (GLuint unit = 0; unit < 8; unit += 2)
        gl.BindImageTexture(unit, textures[0], 1, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA32F);

    GLuint vertex_array = 0, framebuffers[2] = {}, renderbuffer = 0;
    gl.CreateVertexArrays(1, &vertex_array);
    gl.BindVertexArray(vertex_array);
    gl.CreateFramebuffers(2, framebuffers);
    gl.NamedFramebufferTexture(framebuffers[0], GL_COLOR_ATTACHMENT0, textures[0], 0);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers[0]);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers[1]);
    gl.CreateRenderbuffers(1, &renderbuffer);
    gl.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    gl.UseProgram(program_of(gl));
    REQUIRE(gl.GetError() == GL_NO_ERROR);
}

std::vector<float> image_of(nicol_context context, nicol_executor executor) {
    const Stage stage(context);
    nicol_render_options options = plain_options();
    options.executor = executor;
    options.shade_at = NICOL_SHADE_AT_PIXELS;
    return stage.image(options);
}

}  // namespace

HOST_TEST_CASE("every call leaves the application's state as it was") {
    const Application application;
    disarrange(application.gl);
    const GlState before = gl_state(application.gl), names = gl_names(application.gl);
    const auto same = [&](const char* call) {
        INFO(call);
        CHECK(difference(before, gl_state(application.gl)) == "");
    };
    const nicol_context context = make_host_context();
    same("create");
    {
        const Stage stage(context);
        same("stage");
        nicol_render_options options = plain_options();
        for (const nicol_executor executor : {NICOL_EXECUTOR_CPU, NICOL_EXECUTOR_COMPUTE}) {
            options.executor = executor;
            options.shade_at = NICOL_SHADE_AT_PIXELS;
            OK(stage.try_render(options));
            same("render");
        }
        options = plain_options();
        options.method = NICOL_METHOD_REFERENCE;
        options.samples = 1;
        OK(stage.try_render(options));
        same("render by rays");
        static_cast<void>(read_all(stage.framebuffer));
        same("read");
        options.method = 99;
        CHECK(stage.try_render(options) != NICOL_OK);
        same("a render that fails");
        nicol_framebuffer large = nullptr;
        CHECK(nicol_framebuffer_create(context, 16384, 16384, 16, &large) != NICOL_OK);
        same("a framebuffer that fails");
    }
    same("release");
    OK(nicol_context_release(context));
    same("release of the context");
    CHECK(difference(names, gl_names(application.gl)) == "");
}

HOST_TEST_CASE("the application's state does not show in the image") {
    std::vector<float> expected[2];
    constexpr nicol_executor executors[] = {NICOL_EXECUTOR_CPU, NICOL_EXECUTOR_COMPUTE};
    for (int i = 0; i < 2; ++i) expected[i] = image_of(Owned(make_context(NICOL_BACKEND_EGL)), executors[i]);
    const Application application;
    disarrange(application.gl);
    const Owned context(make_host_context());
    for (int i = 0; i < 2; ++i) CHECK(image_of(context, executors[i]) == expected[i]);
}

HOST_TEST_CASE("an error that the application left stays pending and is not taken for ours") {
    const Application application;
    const GladGLContext& gl = application.gl;
    const Owned context(make_host_context());
    const Stage stage(context);
    nicol_render_options options = plain_options();
    options.disabled_optimisations = NICOL_OPTIMISATION_UNCHANGED;
    const std::vector<float> image = stage.image(options);
    const nicol_texture_target wrong = NICOL_TEXTURE_TARGET_INIT;
    GLuint incomplete = 0, buffer = 0;
    gl.CreateFramebuffers(1, &incomplete);
    gl.CreateBuffers(1, &buffer);
    int messages = 0;
    gl.Enable(GL_DEBUG_OUTPUT);
    gl.DebugMessageCallback(
        [](GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar*, const void* count) {
            if (type == GL_DEBUG_TYPE_ERROR) ++*static_cast<int*>(const_cast<void*>(count));
        },
        &messages);
    const struct {
        GLenum error;
        std::function<void()> leave;
    } cases[] = {{GL_INVALID_ENUM, [&] { gl.Enable(GL_TEXTURE_WRAP_S); }},
                 {GL_INVALID_VALUE, [&] { gl.Viewport(0, 0, -1, -1); }},
                 {GL_INVALID_OPERATION, [&] { gl.BindVertexArray(999); }},
                 {GL_INVALID_FRAMEBUFFER_OPERATION,
                  [&] {
                      gl.BlitNamedFramebuffer(incomplete, incomplete, 0, 0, 1, 1, 0, 0, 1, 1,
                                              GL_COLOR_BUFFER_BIT, GL_NEAREST);
                  }},
                 {GL_OUT_OF_MEMORY, [&] { gl.NamedBufferStorage(buffer, PTRDIFF_MAX, nullptr, 0); }}};
    for (const auto& [error, leave] : cases) {
        CAPTURE(error);
        messages = 0;
        leave();
        const int told = messages;
        CHECK(stage.image(options) == image);
        REFUSES(nicol_framebuffer_draw_stokes(stage.framebuffer, 0, &wrong), "does not exist");
        CHECK(messages == told);
        CHECK(gl.IsEnabled(GL_DEBUG_OUTPUT) == GL_TRUE);
        CHECK(gl.GetError() == error);
        CHECK(gl.GetError() == GL_NO_ERROR);
    }
    gl.PopDebugGroup();
    nicol_framebuffer framebuffer = marker<nicol_framebuffer>();
    FAILS(nicol_framebuffer_create(context, 4, 4, 1, &framebuffer), NICOL_ERROR_OPENGL, "GL_STACK_UNDERFLOW");
    CHECK(framebuffer == marker<nicol_framebuffer>());
    CHECK(stage.image(options) == image);
}

HOST_TEST_CASE("the subroutines that the application chose are as before") {
    const Application application;
    const GladGLContext& gl = application.gl;
    const Owned context(make_host_context());
    const auto source_of = [](const char* output) {
        return std::string(R"(#version 450
            subroutine float Number();
            layout(index = 3) subroutine(Number) float one() { return 1.0; }
            layout(index = 5) subroutine(Number) float two() { return 2.0; }
            layout(location = 0) subroutine uniform Number first;
            layout(location = 2) subroutine uniform Number second;)") +
               output;
    };
    const std::string vertex = source_of("void main() { gl_Position = vec4(first(), second(), 0, 1); }"),
                      fragment = source_of("out vec4 c; void main() { c = vec4(first(), second(), 0, 1); }");
    const auto check = [&](const std::string& how) {
        CAPTURE(how);
        const GLuint chosen[2][3] = {{5, 3, 3}, {3, 3, 5}};
        constexpr GLenum stages[] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};
        for (int i = 0; i < 2; ++i) gl.UniformSubroutinesuiv(stages[i], 3, chosen[i]);
        REQUIRE(gl.GetError() == GL_NO_ERROR);
        static_cast<void>(Stage(context).image());
        for (int i = 0; i < 2; ++i)
            for (const GLint location : {0, 2}) {
                GLuint now = 0;
                gl.GetUniformSubroutineuiv(stages[i], location, &now);
                CHECK(now == chosen[i][location]);
            }
        CHECK(gl.GetError() == GL_NO_ERROR);
    };
    gl.UseProgram(
        program_of(gl, {{GL_VERTEX_SHADER, vertex.c_str()}, {GL_FRAGMENT_SHADER, fragment.c_str()}}));
    check("a program");
    gl.UseProgram(0);
    GLuint pipeline = 0;
    gl.CreateProgramPipelines(1, &pipeline);
    gl.BindProgramPipeline(pipeline);
    const char* sources[] = {vertex.c_str(), fragment.c_str()};
    gl.UseProgramStages(pipeline, GL_VERTEX_SHADER_BIT,
                        gl.CreateShaderProgramv(GL_VERTEX_SHADER, 1, &sources[0]));
    gl.UseProgramStages(pipeline, GL_FRAGMENT_SHADER_BIT,
                        gl.CreateShaderProgramv(GL_FRAGMENT_SHADER, 1, &sources[1]));
    check("a pipeline");
}

HOST_TEST_CASE("states in which nothing can be drawn or put back are refused") {
    const Application application;
    const GladGLContext& gl = application.gl;
    const Owned context(make_host_context());
    const Stage stage(context);
    const std::vector<float> image = stage.image();
    GLuint buffer = 0, query = 0, program = 0;
    gl.CreateBuffers(1, &buffer);
    gl.NamedBufferStorage(buffer, 1024, nullptr, 0);
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
    gl.CreateQueries(GL_ANY_SAMPLES_PASSED, 1, &query);
    gl.BeginQuery(GL_ANY_SAMPLES_PASSED, query);
    gl.EndQuery(GL_ANY_SAMPLES_PASSED);
    const auto old = [](const char* name, auto... arguments) {
        reinterpret_cast<void (*)(decltype(arguments)...)>(egl().proc_address(name))(arguments...);
    };
    constexpr GLenum compile = 0x1300, select = 0x1C02, render = 0x1C00;
    std::array<GLuint, 16> selected{};
    struct Case {
        const char* named;
        std::function<void()> begin, end;
    };
    std::vector<Case> cases{
        {"deleted", [&] { gl.UseProgram(program = program_of(gl)), gl.DeleteProgram(program); },
         [&] { CHECK(gl.IsProgram(program) == GL_TRUE), gl.UseProgram(0); }},
        {"failed to link",
         [&] {
             gl.UseProgram(program = program_of(gl));
             attach_and_link(gl, program, {{GL_GEOMETRY_SHADER, "no shader"}});
         },
         [&] { CHECK(GLuint(gl_state(gl)["GL_CURRENT_PROGRAM"][0]) == program), gl.UseProgram(0); }},
        {"transform feedback",
         [&] { gl.UseProgram(captured_program(gl)), gl.BeginTransformFeedback(GL_POINTS); },
         [&] { gl.EndTransformFeedback(), gl.UseProgram(0); }},
        {"conditionally", [&] { gl.BeginConditionalRender(query, GL_QUERY_WAIT); },
         [&] { gl.EndConditionalRender(); }}};
    if (profile_under_test == Profile::compatibility) {
        cases.push_back(
            {"display list", [&] { old("glNewList", GLuint{1}, compile); }, [&] { old("glEndList"); }});
        cases.push_back({"render mode",
                         [&] {
                             old("glSelectBuffer", GLsizei{16}, selected.data());
                             old("glRenderMode", select);
                         },
                         [&] { old("glRenderMode", render); }});
    }
    for (const Case& refused : cases) {
        CAPTURE(std::string(refused.named));
        nicol_framebuffer framebuffer = marker<nicol_framebuffer>();
        refused.begin();
        REQUIRE(gl.GetError() == GL_NO_ERROR);
        FAILS(nicol_framebuffer_create(context, 4, 4, 1, &framebuffer), NICOL_ERROR_UNSUPPORTED,
              refused.named);
        CHECK(framebuffer == marker<nicol_framebuffer>());
        refused.end();
        CHECK(gl.GetError() == GL_NO_ERROR);
        CHECK(stage.image() == image);
    }
}
