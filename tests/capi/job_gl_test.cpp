// SPDX-License-Identifier: MIT
// Tests of renders as jobs: results, order, completion and release.
#include <atomic>
#include <mutex>
#include <thread>

#include "jobs.hpp"

using namespace capi_test;

STAGE_TEST_CASE("a job makes the image that a render makes") {
    for (const nicol_method method : {NICOL_METHOD_FACTORED, NICOL_METHOD_DENSE, NICOL_METHOD_REFERENCE}) {
        nicol_render_options options = plain_options();
        options.method = method;
        options.samples = 4;
        const std::vector<float> image = stage.image(options);
        const Owned other(framebuffer_of(stage.context, 24, 16, 3));
        const Owned job(make(nicol_render_async, stage.scene, &stage.camera, &options, other));
        OK(nicol_job_wait(job, NICOL_WAIT_FOREVER));
        OK(nicol_job_wait(job, 0));
        const nicol_job_status status = poll(job);
        CHECK((status.state == NICOL_JOB_DONE && status.result == NICOL_OK));
        CHECK((status.fraction == 1 && std::string(status.verb) == ""));
        CHECK(read_all(other) == image);
        OK(nicol_job_cancel(job));  // has no effect after the end
        OK(nicol_job_wait(job, NICOL_WAIT_FOREVER));
    }
}

STAGE_TEST_CASE("a job renders the scene as it was, while the scene changes") {
    const nicol_render_options options = traced();
    const std::vector<float> before = stage.image(options);

    const Owned other(framebuffer_of(stage.context, 24, 16, 3));
    Gate gate;
    const Owned first(submit(stage, gated(gate)));
    gate.wait_until_entered();
    const Owned second(make(nicol_render_async, stage.scene, &stage.camera, &options, other));
    // None of these calls may wait for the job, because the job is blocked.
    OK(nicol_scene_set_transform(stage.scene, 0, placed(0.5, 0, 0, 0.2).rows));
    OK(nicol_scene_set_environment(stage.scene, stage.environment, nullptr, 3));
    std::uint32_t channels = 0;
    OK(nicol_scene_get_channels(stage.scene, &channels));
    const Owned third(submit(stage, options));
    gate.open();
    OK(nicol_job_wait(second, NICOL_WAIT_FOREVER));
    OK(nicol_job_wait(third, NICOL_WAIT_FOREVER));
    CHECK(read_all(other) == before);
    const std::vector<float> after = read_all(stage.framebuffer);
    CHECK(after != before);
    OK(nicol_render(stage.scene, &stage.camera, &options, other));
    CHECK(read_all(other) == after);
}

STAGE_TEST_CASE("a render waits for a job of its scene, or says that it is busy") {
    Gate gate;
    const Owned job(submit(stage, gated(gate)));
    gate.wait_until_entered();
    nicol_render_options options = plain_options();
    options.fail_if_busy = 1;
    FAILS(stage.try_render(options), NICOL_ERROR_BUSY, "fail_if_busy");
    OK(Stage(stage.context).try_render(options));  // another scene
    std::atomic<bool> rendered = false;
    std::thread render([&] {
        options.fail_if_busy = 0;
        rendered = stage.try_render(options) == NICOL_OK;
    });
    CHECK(poll(job).state == NICOL_JOB_RUNNING);
    CHECK_FALSE(rendered);
    gate.open();
    render.join();
    CHECK(rendered);
    OK(nicol_job_wait(job, NICOL_WAIT_FOREVER));
    options.fail_if_busy = 1;
    OK(stage.try_render(options));
}

STAGE_TEST_CASE("jobs wait their turn, and end at once when they are cancelled there") {
    const std::vector<float> image = stage.image();
    Gate gate;
    const Owned running(submit(stage, gated(gate)));
    const Owned waiting(submit(stage));
    gate.wait_until_entered();
    const nicol_job_status status = poll(running);
    CHECK((status.state == NICOL_JOB_RUNNING && status.result == NICOL_OK));
    CHECK(std::string(status.verb) == "trace");
    CHECK((status.fraction >= 0 && status.fraction <= 1));
    CHECK(poll(waiting).state == NICOL_JOB_WAITING);
    FAILS(nicol_job_wait(waiting, 0), NICOL_ERROR_TIMEOUT, "0 milliseconds");
    FAILS(nicol_job_wait(running, 1), NICOL_ERROR_TIMEOUT, "1 milliseconds");
    // Cancels the waiting job while the running job still holds the thread.
    OK(nicol_job_cancel(waiting));
    FAILS(nicol_job_wait(waiting, NICOL_WAIT_FOREVER), NICOL_ERROR_CANCELLED, "cancelled");
    CHECK(poll(waiting).state == NICOL_JOB_DONE);
    CHECK(poll(waiting).result == NICOL_ERROR_CANCELLED);
    CHECK(poll(running).state == NICOL_JOB_RUNNING);
    OK(nicol_job_cancel(running));
    CHECK(poll(running).state == NICOL_JOB_RUNNING);
    gate.open();
    FAILS(nicol_job_wait(running, NICOL_WAIT_FOREVER), NICOL_ERROR_CANCELLED, "cancelled");
    CHECK(read_all(stage.framebuffer) == image);
}

STAGE_TEST_CASE("a progress callback stops its job") {
    Gate gate;
    gate.open(0);
    const Owned job(submit(stage, gated(gate)));
    FAILS(nicol_job_wait(job, NICOL_WAIT_FOREVER), NICOL_ERROR_CANCELLED, "progress");
}

TEST_CASE("everything may be released while a job runs and others wait") {
    for (const nicol_backend backend : every_backend()) {
        const nicol_context context = make_context(backend);
        std::atomic<bool> released = false;
        Gate gate;
        {
            const Stage stage(context);
            add_watched(stage, released);
            const nicol_job first = submit(stage, gated(gate));
            const nicol_job second = submit(stage);
            const nicol_job dropped = submit(stage);
            gate.wait_until_entered();
            OK(nicol_job_cancel(dropped));
            for (const nicol_job job : {dropped, first, second}) OK(nicol_job_release(job));
        }  // releases scene, framebuffer and everything else
        OK(nicol_context_release(context));
        CHECK_FALSE(released);
        gate.open();
        released.wait(false);
    }
}

STAGE_TEST_CASE("the message of a failed job is there for every thread that asks") {
    const Owned wrong(framebuffer_of(stage.context, 4, 4, 2));
    const Owned job(make(nicol_render_async, stage.scene, &stage.camera, nullptr, wrong));
    std::vector<std::string> messages(4);
    std::vector<nicol_result> results(4);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < 4; ++i) {
        threads.emplace_back([&, i] {
            results[i] = nicol_job_wait(job, NICOL_WAIT_FOREVER);
            messages[i] = nicol_last_error();
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(results[i] == NICOL_ERROR_INVALID_ARGUMENT);
        CHECK(messages[i].find("colour channels") != std::string::npos);
    }
    CHECK(poll(job).result == NICOL_ERROR_INVALID_ARGUMENT);
    CHECK(poll(job).fraction < 1);
}

TEST_CASE("only so many jobs wait") {
    const Owned context(make_context(NICOL_BACKEND_OSMESA));
    const Stage stage(context);
    Gate gate;
    const Owned running(submit(stage, gated(gate)));
    gate.wait_until_entered();
    std::vector<nicol_job> jobs;
    for (std::size_t i = 0; i < NICOL_MAX_JOBS; ++i) jobs.push_back(submit(stage));
    nicol_job job = marker<nicol_job>();
    const auto refused = [&](const char* text) {
        FAILS(nicol_render_async(stage.scene, &stage.camera, nullptr, stage.framebuffer, &job),
              NICOL_ERROR_BUSY, text);
    };
    refused("256");
    OK(nicol_job_cancel(jobs[100]));  // frees one place in the queue
    jobs.push_back(submit(stage));
    refused("wait");
    CHECK(job == marker<nicol_job>());
    for (const nicol_job one : jobs) OK(nicol_job_cancel(one));
    gate.open();
    OK(nicol_job_wait(running, NICOL_WAIT_FOREVER));
    for (const nicol_job one : jobs) {
        CHECK(nicol_job_wait(one, NICOL_WAIT_FOREVER) == NICOL_ERROR_CANCELLED);
        OK(nicol_job_release(one));
    }
}

TEST_CASE("callbacks may ask and cancel, but not wait") {
    struct Asked {
        nicol_job job = nullptr;
        nicol_scene scene = nullptr;
        std::mutex ready;  // locked until the job is known
        nicol_result waited = NICOL_OK, polled = -1, cancelled = -1, edited = NICOL_OK;
    };
    on_every_stage([](const Stage& stage) {
        Asked asked;
        asked.scene = stage.scene;
        nicol_render_options options = traced();
        options.progress_user = &asked;
        options.progress = [](void* user, const char*, double) -> std::int32_t {
            auto& all = *static_cast<Asked*>(user);
            const std::lock_guard lock(all.ready);
            nicol_job_status status = NICOL_JOB_STATUS_INIT;
            all.polled = nicol_job_poll(all.job, &status);
            all.waited = nicol_job_wait(all.job, NICOL_WAIT_FOREVER);
            all.edited = nicol_scene_set_transform(all.scene, 0, placed(0, 0, 0).rows);
            all.cancelled = nicol_job_cancel(all.job);
            return 1;
        };
        {
            const std::lock_guard lock(asked.ready);
            asked.job = submit(stage, options);
        }
        // The callback cancels the job. A job with no further progress to report ends as done.
        const nicol_result result = nicol_job_wait(asked.job, NICOL_WAIT_FOREVER);
        CHECK((result == NICOL_ERROR_CANCELLED || result == NICOL_OK));
        CHECK(asked.polled == NICOL_OK);
        CHECK(asked.waited == NICOL_ERROR_INVALID_ARGUMENT);
        CHECK(asked.edited == NICOL_ERROR_INVALID_ARGUMENT);
        CHECK(asked.cancelled == NICOL_OK);
        OK(nicol_job_release(asked.job));
    });
}

TEST_CASE("what a scene lets go of must not edit it") {
    struct Removed {
        nicol_scene scene = nullptr;
        nicol_result edited = NICOL_OK;
        bool called = false;
    };
    on_every_stage([](const Stage& stage) {
        Removed removed;
        removed.scene = stage.scene;
        nicol_callback_material parameters = grey_function();
        parameters.user = &removed;
        parameters.release = [](void* user) {
            auto& all = *static_cast<Removed*>(user);
            all.called = true;
            all.edited = nicol_scene_set_transform(all.scene, 0, placed(0, 0, 0).rows);
        };
        const std::uint32_t id = add(stage.scene, stage.mesh,
                                     Owned(make(nicol_material_create_callback, stage.context, &parameters)));
        OK(nicol_scene_remove_instance(stage.scene, id));
        CHECK(removed.called);
        CHECK(removed.edited == NICOL_ERROR_INVALID_ARGUMENT);
    });
}

TEST_CASE("threads submit, change, cancel and wait side by side") {
    const Owned context(make_context(NICOL_BACKEND_OSMESA));
    const Stage stage(context);
    std::vector<std::thread> threads;
    std::vector<int> failures(6);
    for (std::size_t t = 0; t < failures.size(); ++t) {
        threads.emplace_back([&, t] {
            for (int i = 0; i < 8; ++i) {
                nicol_job job = nullptr;
                const auto tell = [&](bool good) { failures[t] += good ? 0 : 1; };
                tell(nicol_render_async(stage.scene, &stage.camera, nullptr, stage.framebuffer, &job) ==
                     NICOL_OK);
                const double x = 0.01 * static_cast<double>(t) + 0.001 * i;
                tell(nicol_scene_set_transform(stage.scene, 0, placed(x, 0, 0).rows) == NICOL_OK);
                if (i % 3 == 2) tell(nicol_job_cancel(job) == NICOL_OK);
                if (i % 4 == 3)
                    tell(nicol_render(stage.scene, &stage.camera, nullptr, stage.framebuffer) == NICOL_OK);
                const nicol_result result = nicol_job_wait(job, NICOL_WAIT_FOREVER);
                tell(result == NICOL_OK || (i % 3 == 2 && result == NICOL_ERROR_CANCELLED));
                tell(nicol_job_release(job) == NICOL_OK);
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (const int count : failures) CHECK(count == 0);
}
