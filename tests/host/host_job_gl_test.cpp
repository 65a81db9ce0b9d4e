// SPDX-License-Identifier: MIT
// Tests of jobs inside an application's OpenGL. Jobs compute on other threads and issue commands only while
// the context is lent.
#include <thread>

#include "capi/jobs.hpp"
#include "host/egl_host.hpp"
#include "host/gl_state.hpp"

using namespace host_test;

namespace {

/// An application, and a stage of a context inside it.
struct Hosted {
    Application application;
    Owned<nicol_context> context{make_host_context()};
    Stage stage{context};
};

nicol_render_options options_of(nicol_method method, nicol_executor executor) {
    nicol_render_options options = plain_options();
    options.method = method;
    options.executor = executor;
    options.samples = 4;
    return options;
}
nicol_render_options drawn() {
    return options_of(NICOL_METHOD_FACTORED, NICOL_EXECUTOR_CPU);
}

nicol_job_status poll_until_done(nicol_job job) {
    nicol_job_status status = poll(job);
    while (status.state != NICOL_JOB_DONE) {
        std::this_thread::yield();
        status = poll(job);
    }
    return status;
}

}  // namespace

HOST_TEST_CASE("a job in an application makes the image that a render makes, and leaves its state") {
    const Hosted hosted;
    for (const nicol_render_options& options :
         {options_of(NICOL_METHOD_FACTORED, NICOL_EXECUTOR_CPU),
          options_of(NICOL_METHOD_FACTORED, NICOL_EXECUTOR_COMPUTE),
          options_of(NICOL_METHOD_DENSE, NICOL_EXECUTOR_CPU),
          options_of(NICOL_METHOD_DENSE, NICOL_EXECUTOR_COMPUTE),
          options_of(NICOL_METHOD_REFERENCE, NICOL_EXECUTOR_AUTOMATIC)}) {
        CAPTURE(options.method);
        CAPTURE(options.executor);
        const std::vector<float> image = hosted.stage.image(options);
        const Stage other(hosted.context);
        const GlState before = gl_state(hosted.application.gl);
        const Owned waited(submit(other, options));
        OK(nicol_job_wait(waited, NICOL_WAIT_FOREVER));
        CHECK(difference(before, gl_state(hosted.application.gl)) == "");
        CHECK(read_all(other.framebuffer) == image);
        const Stage third(hosted.context);
        const Owned polled(submit(third, options));
        CHECK(poll_until_done(polled).result == NICOL_OK);
        CHECK(difference(before, gl_state(hosted.application.gl)) == "");
        CHECK(read_all(third.framebuffer) == image);
    }
}

HOST_TEST_CASE("the application goes on while a job bakes") {
    const Hosted hosted;
    Gate gate;
    const Owned job(submit(hosted.stage, gated(gate, NICOL_METHOD_FACTORED)));
    gate.wait_until_entered();
    const GlState before = gl_state(hosted.application.gl);
    for (int frame = 0; frame < 100; ++frame) CHECK(poll(job).state == NICOL_JOB_RUNNING);
    FAILS(nicol_job_wait(job, 0), NICOL_ERROR_TIMEOUT, "0 milliseconds");
    FAILS(nicol_job_wait(job, 1), NICOL_ERROR_TIMEOUT, "1 milliseconds");
    nicol_gl_texture texture = NICOL_GL_TEXTURE_INIT;
    OK(nicol_framebuffer_get_texture(hosted.stage.framebuffer, 0, &texture));
    CHECK(difference(before, gl_state(hosted.application.gl)) == "");
    gate.open();
    OK(nicol_job_wait(job, NICOL_WAIT_FOREVER));
}

HOST_TEST_CASE("a call that waits for a job lends it the context") {
    const Hosted hosted;
    nicol_render_options options = drawn();
    options.shade_at = NICOL_SHADE_AT_VERTICES;  // whose image is drawn with the framebuffer locked
    OK(nicol_scene_set_transform(hosted.stage.scene, 0, placed(0, 0, 0).rows));
    const std::vector<float> image = hosted.stage.image(options);
    const Stage other(hosted.context);
    for (const auto& wait : std::initializer_list<std::function<void(nicol_job)>>{
             [&](nicol_job) { OK(other.try_render(options)); },
             [&](nicol_job job) {
                 // Surfaces are uploaded before the framebuffer is locked.
                 while (read_all(other.framebuffer) != image) static_cast<void>(poll(job));
             },
         }) {
        OK(nicol_scene_set_transform(other.scene, 0, placed(0.5, 0, 0).rows));
        OK(other.try_render(options));
        OK(nicol_scene_set_transform(other.scene, 0, placed(0, 0, 0).rows));
        Gate gate;
        options.progress = Gate::callback;
        options.progress_user = &gate;
        const Owned job(submit(other, options));
        options.progress = nullptr;
        gate.wait_until_entered();
        gate.open();
        wait(job);
        OK(nicol_job_wait(job, NICOL_WAIT_FOREVER));
        CHECK(read_all(other.framebuffer) == image);
    }
}

HOST_TEST_CASE("the context is lent where it is current, and nowhere else") {
    const Hosted hosted;
    const Owned job(submit(hosted.stage, drawn()));
    Application::leave();
    nicol_framebuffer framebuffer = marker<nicol_framebuffer>();
    const auto refused = [&] {
        FAILS(nicol_job_wait(job, NICOL_WAIT_FOREVER), NICOL_ERROR_NOT_CURRENT, "not current");
        FAILS(nicol_framebuffer_create(hosted.context, 4, 4, 1, &framebuffer), NICOL_ERROR_NOT_CURRENT,
              "not current");
    };
    refused();
    std::thread(refused).join();
    {
        const Application another;
        refused();
        CHECK(poll(job).state != NICOL_JOB_DONE);
    }
    std::thread([&] {
        hosted.application.enter();
        OK(nicol_job_wait(job, NICOL_WAIT_FOREVER));
        Application::leave();
    }).join();
    OK(nicol_job_wait(job, NICOL_WAIT_FOREVER));  // the job is already done
    hosted.application.enter();
}

HOST_TEST_CASE("a job that waits for the context can be cancelled") {
    struct Word {
        std::thread::id thread = std::this_thread::get_id();
        bool current = true;
        bool asked = false;
    } word;
    const Application application;
    nicol_host access = host();
    access.user = &word;
    access.is_current = [](void* user) -> std::int32_t {
        auto& given = *static_cast<Word*>(user);
        if (std::this_thread::get_id() != given.thread) return 0;
        given.asked = true;
        return given.current ? 1 : 0;
    };
    const Owned context(make(nicol_context_create_host, &access, nullptr));
    const Stage stage(context);
    const std::vector<float> image = stage.image();
    OK(nicol_scene_set_transform(stage.scene, 0, placed(0.5, 0, 0).rows));
    const Owned job(submit(stage, drawn()));
    word.current = word.asked = false;
    while (!word.asked) CHECK(poll(job).state != NICOL_JOB_DONE);  // called only once there are commands
    OK(nicol_job_cancel(job));
    CHECK(poll_until_done(job).result == NICOL_ERROR_CANCELLED);
    word.current = true;
    CHECK(read_all(stage.framebuffer) == image);
    CHECK(stage.image() != image);
}

HOST_TEST_CASE("an application that cannot lend its context fails the job, and says why") {
    const Hosted hosted;
    const GladGLContext& gl = hosted.application.gl;
    const char* source = "#version 450\nvoid main() { gl_Position = vec4(0, 0, 0, 1); }";
    const GLuint program = gl.CreateShaderProgramv(GL_VERTEX_SHADER, 1, &source);
    const Owned job(submit(hosted.stage, drawn()));
    gl.UseProgram(program);
    gl.DeleteProgram(program);
    FAILS(nicol_job_wait(job, NICOL_WAIT_FOREVER), NICOL_ERROR_UNSUPPORTED, "deleted");
    gl.UseProgram(0);
    OK(hosted.stage.try_render(drawn()));
}

HOST_TEST_CASE("a job ends that nobody can lend the context any more") {
    const Application application;
    std::atomic<bool> released = false;
    Gate gate;
    {
        const Owned context(make_host_context());
        const Stage stage(context);
        add_watched(stage, released);
        const Owned job(submit(stage, gated(gate, NICOL_METHOD_FACTORED)));
        gate.wait_until_entered();
    }
    CHECK_FALSE(released);
    gate.open();
    released.wait(false);
}
