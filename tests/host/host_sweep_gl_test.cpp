// SPDX-License-Identifier: MIT
// Tests of each OpenGL state at an unusual value: it neither affects images nor is changed by calls.
#include "host/egl_host.hpp"
#include "host/gl_state.hpp"
#include "host/unusual_state.hpp"

using namespace host_test;

namespace {

constexpr GLsizei width = 24, height = 16;

/// Returns every state. Settings share eight images, which differ if any of them shows. Operations that are
/// begun exclude each other.
std::vector<UnusualStates> every_state() {
    UnusualStates settings = unusual_settings();
    if (profile_under_test == Profile::compatibility)
        for (const UnusualState& old : unusual_old_settings()) settings.push_back(old);
    std::vector<UnusualStates> all(8);
    for (std::size_t i = 0; i < settings.size(); ++i) all[i % 8].push_back(settings[i]);
    for (const UnusualState& binding : unusual_bindings()) all.push_back({binding});
    return all;
}

/// Uploads, renders with threads and on the device, reads, and draws into `texture`, nearer than what `depth`
/// has. Returns the images read.
std::vector<float> images(nicol_context context, GLuint texture, GLuint depth) {
    const Stage stage(context);
    std::vector<float> all;
    nicol_render_options options = plain_options();
    options.shade_at = NICOL_SHADE_AT_PIXELS;
    options.aovs = NICOL_AOV_DEPTH;
    options.order_low = 1;
    options.order_high = 3;
    for (const nicol_executor executor : {NICOL_EXECUTOR_CPU, NICOL_EXECUTOR_COMPUTE}) {
        options.executor = executor;
        const std::vector<float> image = stage.image(options);
        all.insert(all.end(), image.begin(), image.end());
    }
    nicol_texture_target target = NICOL_TEXTURE_TARGET_INIT;
    target.texture = texture;
    target.depth_texture = depth;
    target.depth_near = 1;
    const nicol_observation seen = NICOL_OBSERVATION_INIT;
    OK(nicol_framebuffer_draw_observation(stage.framebuffer, &seen, &target));
    return all;
}

std::vector<float> texels(const GladGLContext& gl, GLuint texture) {
    std::vector<float> values(std::size_t{4} * width * height);
    gl.GetTextureImage(texture, 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(values.size() * sizeof(float)),
                       values.data());
    return values;
}

}  // namespace

HOST_TEST_CASE("no state of the application's shows in an image or is changed by a call") {
    const Application application;
    const GladGLContext& gl = application.gl;
    const Owned context(make_host_context());
    GLuint texture = 0, depth = 0;
    gl.CreateTextures(GL_TEXTURE_2D, 1, &texture);
    gl.TextureStorage2D(texture, 1, GL_RGBA32F, width, height);
    gl.CreateTextures(GL_TEXTURE_2D, 1, &depth);
    gl.TextureStorage2D(depth, 1, GL_DEPTH_COMPONENT32F, width, height);
    const GLfloat middle = 0.64F;  // hides a part of the body
    const auto clear = [&] {
        gl.ClearTexImage(texture, 0, GL_RGBA, GL_FLOAT, nullptr);
        gl.ClearTexImage(depth, 0, GL_DEPTH_COMPONENT, GL_FLOAT, &middle);
    };
    clear();
    const std::vector<float> expected = images(context, texture, depth), drawn = texels(gl, texture);
    const GlState initial = gl_state(gl);
    for (const UnusualStates& states : every_state()) {
        std::string names;
        clear();
        for (const UnusualState& state : states) {
            names += state.name + ". ";
            state.set(gl, true);
        }
        CAPTURE(names);
        REQUIRE(gl.GetError() == GL_NO_ERROR);
        const GlState before = gl_state(gl);
        CHECK(images(context, texture, depth) == expected);
        CHECK(difference(before, gl_state(gl)) == "");
        for (auto state = states.rbegin(); state != states.rend(); ++state) state->set(gl, false);
        CHECK(texels(gl, texture) == drawn);
        REQUIRE(difference(initial, gl_state(gl)) == "");
    }
}
