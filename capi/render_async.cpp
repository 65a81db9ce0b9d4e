// SPDX-License-Identifier: MIT
// Renders as jobs.
#include "render.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

// The caller's progress callback behind the job's own.
std::function<bool(const char*, double)> job_progress(Job& job, const RenderOptions& options) {
    return [&job, callback = options.progress](const char* verb, double fraction) {
        job.report(verb, fraction);
        if (!callback) return true;
        const bool go_on = callback(verb, fraction);
        job.report(verb, fraction);  // a cancellation may have come meanwhile
        return go_on;
    };
}

}  // namespace

nicol_result nicol_render_async(nicol_scene scene, const nicol_camera* camera,
                                const nicol_render_options* options, nicol_framebuffer framebuffer,
                                nicol_job* job) {
    return guarded([&] {
        require(job, "job");
        const nicol_scene_impl& self = resolve(scene);
        const nicol_framebuffer_impl& target = resolve(framebuffer);
        require_same_context(self, target);
        const RenderCall call = read_render_call(camera, options);
        if (self.session->gl->info().backend == gl::Backend::host) {
            throw Error(ErrorCode::unsupported,
                        "jobs run on a thread of their own, where a host's OpenGL context is not current");
        }
        refuse_in_callback(*self.session);
        Scene snapshot;
        {
            const Edit edit(self);
            snapshot = self.content->scene;
        }
        auto made = std::make_shared<Job>([call, snapshot = std::move(snapshot), session = self.session,
                                           state = self.content, target = target.content](Job& running) {
            const SessionLock lock(session);
            running.begin();
            RenderOptions options = call.options;
            options.progress = job_progress(running, call.options);
            state->renderer.render(snapshot, call.camera, options, *target);
        });
        nicol_job handle = make_handle<nicol_job_impl>(self.session, made);
        try {
            self.session->job_queue().add(made);
        } catch (...) {
            release(handle);
            throw;
        }
        *job = handle;
    });
}

nicol_result nicol_job_poll(nicol_job job, nicol_job_status* status) {
    return guarded([&] { write_struct(status, resolve(job).content->status(), "status"); });
}

nicol_result nicol_job_wait(nicol_job job, uint32_t timeout_ms) {
    nicol_result result = NICOL_OK;
    const nicol_result called = guarded([&] {
        const nicol_job_impl& self = resolve(job);
        refuse_in_callback(*self.session);
        const auto at_most = timeout_ms == NICOL_WAIT_FOREVER
                                 ? std::nullopt
                                 : std::optional(std::chrono::milliseconds(timeout_ms));
        const std::optional<nicol_result> done = self.content->wait(at_most);
        if (!done) {
            throw Error(ErrorCode::timeout,
                        "the job is not done after " + std::to_string(timeout_ms) + " milliseconds");
        }
        result = *done;
    });
    return called == NICOL_OK ? result : called;
}

nicol_result nicol_job_cancel(nicol_job job) {
    return guarded([&] { resolve(job).content->cancel(); });
}

nicol_result nicol_job_retain(nicol_job job) {
    return retain(job);
}
nicol_result nicol_job_release(nicol_job job) {
    return release(job);
}
