// SPDX-License-Identifier: MIT
// An application's OpenGL state, however odd, is the same after every call, and does not show in the image.
#include "host/egl_host.hpp"
#include "host/gl_state.hpp"

using namespace host_test;

namespace {

GLuint program_of(const GladGLContext& gl, std::initializer_list<std::pair<GLenum, const char*>> shaders) {
    const GLuint program = gl.CreateProgram();
    for (const auto& [stage, source] : shaders) {
        const GLuint shader = gl.CreateShader(stage);
        gl.ShaderSource(shader, 1, &source, nullptr);
        gl.CompileShader(shader);
        gl.AttachShader(program, shader);
        gl.DeleteShader(shader);
    }
    gl.LinkProgram(program);
    return program;
}
GLuint program_of(const GladGLContext& gl) {
    return program_of(gl,
                      {{GL_VERTEX_SHADER, "#version 450\nvoid main() { gl_Position = vec4(0, 0, 0, 1); }"},
                       {GL_FRAGMENT_SHADER, "#version 450\nout vec4 c; void main() { c = vec4(1); }"}});
}

/// Nothing as a fresh context has it; most of it would spoil an image drawn with it.
void disarrange(const GladGLContext& gl, bool compatibility) {
    if (compatibility) {
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
        gl.BlendFunci(i, GL_ZERO, GL_ONE);
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

TEST_CASE("every call leaves the application's state as it was") {
    for (const Profile profile : every_profile) {
        CAPTURE(static_cast<int>(profile));
        const Application application(profile);
        disarrange(application.gl, profile == Profile::compatibility);
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
}

TEST_CASE("the application's state does not show in the image") {
    std::vector<float> expected[2];
    constexpr nicol_executor executors[] = {NICOL_EXECUTOR_CPU, NICOL_EXECUTOR_COMPUTE};
    for (int i = 0; i < 2; ++i) expected[i] = image_of(Owned(make_context(NICOL_BACKEND_EGL)), executors[i]);
    for (const Profile profile : every_profile) {
        CAPTURE(static_cast<int>(profile));
        const Application application(profile);
        disarrange(application.gl, profile == Profile::compatibility);
        const Owned context(make_host_context());
        for (int i = 0; i < 2; ++i) CHECK(image_of(context, executors[i]) == expected[i]);
    }
}

TEST_CASE("an error that the application left is told and not taken for ours") {
    const Application application;
    std::vector<std::string> told;
    nicol_context_options options = NICOL_CONTEXT_OPTIONS_INIT;
    options.log = [](void* user, std::uint32_t severity, nicol_result, const char* message) {
        if (severity < NICOL_LOG_NOTICE) return;
        static_cast<std::vector<std::string>*>(user)->emplace_back(message);
    };
    options.log_user = &told;
    const nicol_host access = host();
    const Owned context(make(nicol_context_create_host, &access, &options));
    application.gl.Enable(GL_TEXTURE_WRAP_S);
    const Owned framebuffer(framebuffer_of(context, 4, 4, 1));
    REQUIRE(told.size() == 1);
    CHECK(told[0].find("GL_INVALID_ENUM") != std::string::npos);
    CHECK(application.gl.GetError() == GL_NO_ERROR);
}

TEST_CASE("what cannot be put back is refused") {
    const Application application;
    const GladGLContext& gl = application.gl;
    const nicol_context context = make_host_context();
    nicol_framebuffer framebuffer = marker<nicol_framebuffer>();
    const GLuint program = program_of(gl);
    gl.UseProgram(program);
    gl.DeleteProgram(program);
    FAILS(nicol_framebuffer_create(context, 4, 4, 1, &framebuffer), NICOL_ERROR_UNSUPPORTED, "deleted");
    CHECK(gl.IsProgram(program) == GL_TRUE);
    gl.UseProgram(0);
    CHECK(framebuffer == marker<nicol_framebuffer>());

    gl.UseProgram(program_of(gl, {{GL_VERTEX_SHADER,
                                   "#version 450\nlayout(xfb_buffer = 0, xfb_offset = 0) out vec4 v;"
                                   "void main() { v = vec4(1); gl_Position = v; }"}}));
    GLuint buffer = 0;
    gl.CreateBuffers(1, &buffer);
    gl.NamedBufferStorage(buffer, 1024, nullptr, 0);
    gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
    gl.BeginTransformFeedback(GL_POINTS);
    REQUIRE(gl.GetError() == GL_NO_ERROR);
    FAILS(nicol_framebuffer_create(context, 4, 4, 1, &framebuffer), NICOL_ERROR_UNSUPPORTED, "feedback");
    gl.PauseTransformFeedback();
    OK(nicol_framebuffer_create(context, 4, 4, 1, &framebuffer));
    gl.ResumeTransformFeedback();
    gl.EndTransformFeedback();
    CHECK(gl.GetError() == GL_NO_ERROR);
    OK(nicol_framebuffer_release(framebuffer));
    OK(nicol_context_release(context));
}
