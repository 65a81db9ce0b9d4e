// SPDX-License-Identifier: MIT
// Tests of renders in an application's context that run out of memory: its state comes back all the same.
#include "host/egl_host.hpp"
#include "host/gl_state.hpp"
#include "host/unusual_state.hpp"
#include "memory/sweep.hpp"

using namespace host_test;
using namespace memory_test;

HOST_TEST_CASE("a frame that lacks memory gives the application its state back and harms no other frame") {
    const Application application;
    const GladGLContext& gl = application.gl;
    const Owned context(make_host_context());
    Stage stage(context);
    constexpr double shifts[] = {0, 0.1};
    nicol_render_options options = plain_options();
    options.shade_at = NICOL_SHADE_AT_PIXELS;
    for (const UnusualState& state : unusual_bindings()) state.set(gl, true);
    const GlState before = gl_state(gl);
    for (const nicol_executor executor : {NICOL_EXECUTOR_CPU, NICOL_EXECUTOR_COMPUTE}) {
        CAPTURE(static_cast<int>(executor));
        options.executor = executor;
        sweep_frames(
            [&](std::size_t k) {
                stage.camera.shift[0] = shifts[k];
                return stage.try_render(options);
            },
            [&] { return read_all(stage.framebuffer); },
            [&] { REQUIRE(difference(before, gl_state(gl)) == ""); });
    }
}
