// SPDX-License-Identifier: MIT
// Tests of how many OpenGL calls a frame makes, and of a host that sets its own state after each call.
#include "gl_counter.hpp"
#include "host/egl_host.hpp"
#include "host/unusual_state.hpp"

using namespace host_test;

namespace {

nicol_host counted_host(std::uint32_t flags) {
    nicol_host access = host();
    access.flags = flags;
    access.get_proc_address = [](void*, const char* name) {
        return counted_gl(name, proc_address(nullptr, name));
    };
    access.is_current = [](void*) { return std::int32_t{egl().current_context() != EGL_NO_CONTEXT}; };
    return access;
}

nicol_context counted_context(std::uint32_t flags) {
    const nicol_host access = counted_host(flags);
    const nicol_context_options options = two_threads(NICOL_BACKEND_AUTOMATIC);
    return make(nicol_context_create_host, &access, &options);
}

nicol_render_options shaded(nicol_shade_at shade_at, nicol_executor executor) {
    nicol_render_options options = plain_options();
    options.shade_at = shade_at;
    options.executor = executor;
    return options;
}

nicol_render_options by_threads(nicol_shade_at shade_at) {
    return shaded(shade_at, NICOL_EXECUTOR_CPU);
}

/// Returns the calls of a frame after the camera moved.
GlCalls calls_of_frame(nicol_context context, const nicol_render_options& options) {
    Stage stage(context);
    OK(stage.try_render(options));
    stage.camera.shift[0] += 0.01;
    reset_gl_calls();
    OK(stage.try_render(options));
    return gl_calls();
}

struct Way {
    nicol_shade_at shade_at;
    nicol_executor executor;
    std::uint64_t polite;  ///< most calls of a frame that saves and restores the host's state
    std::uint64_t free;    ///< and of one that does not
};
constexpr Way kWays[] = {{NICOL_SHADE_AT_VERTICES, NICOL_EXECUTOR_CPU, 300, 120},
                         {NICOL_SHADE_AT_PIXELS, NICOL_EXECUTOR_CPU, 300, 120},
                         {NICOL_SHADE_AT_VERTICES, NICOL_EXECUTOR_COMPUTE, 300, 120},
                         {NICOL_SHADE_AT_PIXELS, NICOL_EXECUTOR_COMPUTE, 300, 170}};

}  // namespace

HOST_TEST_CASE("a frame saves and restores the state once, with few calls") {
    const Application application;
    const Owned context(counted_context(0));
    for (const Way& way : kWays) {
        const GlCalls calls = calls_of_frame(context, shaded(way.shade_at, way.executor));
        CHECK(calls.all <= way.polite);
        CHECK(calls.queries > 0);
        CHECK(calls.errors <= 8);
    }
    const Owned validating(counted_context(NICOL_HOST_VALIDATE));
    CHECK(calls_of_frame(validating, by_threads(NICOL_SHADE_AT_VERTICES)).errors > 8);
}

HOST_TEST_CASE("a host that sets its own state pays for no queries and for few calls") {
    const Application application;
    const Owned context(counted_context(NICOL_HOST_SETS_STATE));
    for (const Way& way : kWays) {
        const GlCalls calls = calls_of_frame(context, shaded(way.shade_at, way.executor));
        CHECK(calls.all <= way.free);
        CHECK(calls.queries == 0);
        CHECK(calls.errors <= 8);
    }
}

HOST_TEST_CASE("a frame without changes makes no calls but the question whether the context is current") {
    const Application application;
    for (const std::uint32_t flags : {0U, NICOL_HOST_SETS_STATE}) {
        const Owned context(counted_context(flags));
        const Stage stage(context);
        stage.render();
        reset_gl_calls();
        stage.render();
        CHECK(gl_calls().all == (flags == 0 ? 3 : 0));
    }
}

HOST_TEST_CASE("no state of a host that sets its own shows in an image") {
    const Application application;
    const Owned context(counted_context(NICOL_HOST_SETS_STATE)), polite(make_host_context());
    Stage stage(context), expected(polite);
    for (const nicol_executor executor : {NICOL_EXECUTOR_CPU, NICOL_EXECUTOR_COMPUTE}) {
        nicol_render_options options = by_threads(NICOL_SHADE_AT_PIXELS);
        options.executor = executor;
        application.gl.UseProgram(0);
        for (const UnusualState& state : unusual_settings()) state.set(application.gl, false);
        stage.camera.shift[0] = expected.camera.shift[0] += 0.01;
        const std::vector<float> image = expected.image(options);
        for (const UnusualState& state : unusual_settings()) {
            CAPTURE(state.name);
            state.set(application.gl, true);
            REQUIRE(application.gl.GetError() == GL_NO_ERROR);
        }
        CHECK(stage.image(options) == image);
    }
}
